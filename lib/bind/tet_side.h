// SPDX-License-Identifier: GPL-3.0-or-later
// Where a point lies with respect to one tet, and its weights there, from the same few products.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "core/vec3.h"
#include "geometry/predicates.h"

namespace crumple::bind {

enum class Side { outside, border, inside };

struct TetSide {
    Side side = Side::outside;
    std::array<double, 4> weights{};  // sum 1; filled unless outside, then none is negative
};

// Six times the signed volumes of the tet with one corner after the other replaced by p.
struct SubVolumes {
    SubVolumes(const std::array<Vec3, 4>& tet, Vec3 p) {
        const Vec3 a = tet[0] - p;
        const Vec3 b = tet[1] - p;
        const Vec3 c = tet[2] - p;
        const Vec3 d = tet[3] - p;
        const Vec3 ab = cross(a, b);
        const Vec3 cd = cross(c, d);
        of = {dot(b, cd), -dot(a, cd), dot(d, ab), -dot(c, ab)};
        double largest = 0;
        for (const Vec3& corner : {a, b, c, d}) {
            largest = std::max({largest, std::fabs(corner.x), std::fabs(corner.y), std::fabs(corner.z)});
        }
        // Six products of three differences, each at most largest^3 and rounded a handful of times: 6 * 10 * 2^-53.
        error = 1e-14 * largest * largest * largest;
    }
    std::array<double, 4> of;
    double error;
};

// Exact side of the face opposite `corner`: +1 where the tet is.
inline int exact_side(const std::array<Vec3, 4>& tet, int corner, Vec3 p) {
    std::array<Vec3, 4> moved = tet;
    moved[corner] = p;
    return orient3d(moved[0], moved[1], moved[2], moved[3]);
}

// Exact; the tet is positive.
inline TetSide side_of_tet(const std::array<Vec3, 4>& tet, Vec3 p) {
    const SubVolumes volume(tet, p);
    for (const double v : volume.of) {
        if (v < -volume.error) return {};
    }
    TetSide result{Side::inside, volume.of};
    for (int corner = 0; corner < 4; ++corner) {
        if (volume.of[corner] > volume.error) continue;
        const int side = exact_side(tet, corner, p);
        if (side < 0) return {};
        if (side == 0) result.side = Side::border;
        result.weights[corner] = side == 0 ? 0 : std::max(volume.of[corner], 0.0);
    }
    const double sum = result.weights[0] + result.weights[1] + result.weights[2] + result.weights[3];
    for (double& w : result.weights) w = sum > 0 ? w / sum : 0.25;
    return result;
}

}
