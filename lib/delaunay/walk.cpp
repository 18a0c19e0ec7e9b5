// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/walk.h"

#include <algorithm>

#include "geometry/predicates.h"

namespace crumple::delaunay {
namespace {

// A walk in plain floating point may turn in circles among slivers; after this many steps signs become exact.
constexpr int floating_steps = 4096;

Vec3 corner_position(const LiftedHull& hull, const Facet& facet, int corner) {
    return hull.sites().at[facet.vertex[corner]].position();
}

// The corner whose opposite face the point lies farthest beyond, measured by volume; -1 when beyond none.
int face_towards(const LiftedHull& hull, const Facet& facet, Vec3 point) {
    const Vec3 a = corner_position(hull, facet, 0) - point;
    const Vec3 b = corner_position(hull, facet, 1) - point;
    const Vec3 c = corner_position(hull, facet, 2) - point;
    const Vec3 d = corner_position(hull, facet, 3) - point;
    const Vec3 ab = cross(a, b);
    const Vec3 cd = cross(c, d);
    const double volume[4] = {dot(b, cd), -dot(a, cd), dot(d, ab), -dot(c, ab)};
    const int lowest = static_cast<int>(std::min_element(volume, volume + 4) - volume);
    return volume[lowest] < 0 ? lowest : -1;
}

int face_towards_exactly(const LiftedHull& hull, const Facet& facet, Vec3 point) {
    for (int corner = 0; corner < 4; ++corner) {
        const int* face = tet_face_corners[corner];
        if (orient3d(corner_position(hull, facet, face[0]), corner_position(hull, facet, face[1]),
                     corner_position(hull, facet, face[2]), point, hull.sites().grain) > 0) {
            return corner;
        }
    }
    return -1;
}

Index finite_neighbour(const LiftedHull& hull, Index facet) {
    const Facet& f = hull.facets()[facet];
    for (int corner = 1; corner < 4; ++corner) {
        if (f.vertex[corner] == hull.sites().infinity()) return f.neighbour[corner] / 4;
    }
    return facet;
}

// With exact signs the walk ends: Delaunay triangulations have no cycles in front of a point [Edelsbrunner 1990], and a
// tet that holds the point is one whose sphere does.
Index walk_exactly(LiftedHull& hull, Index site, Index facet) {
    const Vec3 point = hull.sites().at[site].position();
    facet = finite_neighbour(hull, facet);
    while (!hull.is_infinite(facet)) {
        const Facet& f = hull.facets()[facet];
        const int corner = face_towards_exactly(hull, f, point);
        if (corner < 0) break;
        facet = f.neighbour[corner] / 4;
    }
    return facet;
}

}

Index walk_to_seen_facet(LiftedHull& hull, Index site, Index start) {
    const Vec3 point = hull.sites().at[site].position();
    if (hull.sees_certainly(site, start)) return start;
    Index facet = finite_neighbour(hull, start);
    for (int step = 0; step < floating_steps; ++step) {
        if (hull.sees_certainly(site, facet)) return facet;
        if (hull.is_infinite(facet)) break;
        const Facet& f = hull.facets()[facet];
        const int corner = face_towards(hull, f, point);
        if (corner < 0) break;
        facet = f.neighbour[corner] / 4;
    }
    return hull.sees(site, facet) ? facet : walk_exactly(hull, site, facet);
}

}
