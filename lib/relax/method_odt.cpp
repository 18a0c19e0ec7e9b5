// SPDX-License-Identifier: GPL-3.0-or-later
// Optimal Delaunay triangulation [Chen and Xu 2004, "Optimal Delaunay triangulations"; Alliez, Cohen-Steiner, Yvinec,
// Desbrun 2005, "Variational tetrahedral meshing"]: the node that minimizes the error of interpolating |x|^2 over its
// star lies at
//     x* = sum_t |t| c_t / sum_t |t|,  c_t the centre of the sphere through the corners of t.
#include "geometry/measures.h"
#include "relax/method.h"

namespace crumple::relax {

namespace {

// |t| (c_t - a): the flatness of a sliver, by which its far centre would be divided, cancels.
Vec3 weighted_centre(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 ad = d - a;
    return (cross(ac, ad) * dot(ab, ab) + cross(ad, ab) * dot(ac, ac) + cross(ab, ac) * dot(ad, ad)) / 12;
}

}

Vec3 target_odt(const Star& star) {
    const Vec3 origin = star.mesh.positions[star.node];
    Vec3 moment;
    double volume = 0;
    for (const Index t : star.tets) {
        const auto& [a, b, c, d] = star.mesh.tets[t];
        const auto& p = star.mesh.positions;
        const double share = signed_volume(p[a], p[b], p[c], p[d]);
        moment += (p[a] - origin) * share + weighted_centre(p[a], p[b], p[c], p[d]);
        volume += share;
    }
    return origin + moment / volume;
}

}
