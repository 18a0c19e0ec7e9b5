// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a point set. Whatever it is, delaunay ends, gives positive tets whose neighbours match and whose
// spheres are empty of the point across each face, and the same ones in every order.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "delaunay/delaunay.h"
#include "geometry/predicates.h"

namespace {

using namespace crumple;

void require(bool holds) {
    if (!holds) std::abort();
}

// The first byte says how coordinates are read: raw doubles, floats, or small integers (coplanar and cospherical).
std::vector<Vec3> points_from(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return {};
    const int kind = data[0] % 4;
    const std::size_t width = kind == 0 ? 8 : kind == 1 ? 4 : 1;
    const std::size_t count = std::min<std::size_t>((size - 1) / (3 * width), kind == 0 ? 24 : 64);
    std::vector<Vec3> points(count);
    const std::uint8_t* next = data + 1;
    for (Vec3& p : points) {
        for (int axis = 0; axis < 3; ++axis, next += width) {
            if (kind == 0) {
                std::memcpy(&p[axis], next, sizeof(double));
            } else if (kind == 1) {
                float value = 0;
                std::memcpy(&value, next, sizeof value);
                p[axis] = value;
            } else {
                p[axis] = kind == 2 ? *next % 8 : *next * 0.1;
            }
        }
    }
    return points;
}

void require_delaunay(const TetMesh& mesh) {
    const auto& p = mesh.positions;
    for (Index tet = 0; tet < mesh.tets.size(); ++tet) {
        const Tet& t = mesh.tets[tet];
        require(orient3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) > 0);
        for (int corner = 0; corner < 4; ++corner) {
            const Index other = mesh.neighbours[tet][corner];
            if (other == none) continue;
            const auto& back = mesh.neighbours[other];
            const auto place = std::find(back.begin(), back.end(), tet);
            require(place != back.end());
            const Index apex = mesh.tets[other][static_cast<std::size_t>(place - back.begin())];
            require(in_sphere(p[t[0]], p[t[1]], p[t[2]], p[t[3]], p[apex]) <= 0);
        }
    }
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    PointSet points;
    points.positions = points_from(data, size);
    const bool is_whole = std::all_of(points.positions.begin(), points.positions.end(), is_finite<double>);
    try {
        const auto expected = delaunay::tetrahedralize(points, {delaunay::Order::quickhull});
        require(is_whole);
        require_delaunay(expected.mesh);
        std::reverse(points.positions.begin(), points.positions.end());
        for (const auto order : {delaunay::Order::sampled, delaunay::Order::brio}) {
            const auto result = delaunay::tetrahedralize(points, {order});
            require(result.report.dimension == expected.report.dimension);
            require(result.mesh.neighbours == expected.mesh.neighbours);
        }
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::bad_input && !is_whole);
    }
    return 0;
}
