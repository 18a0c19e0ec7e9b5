// SPDX-License-Identifier: GPL-3.0-or-later
// Centroidal patch tessellation [Chen and Holst 2011, "Efficient mesh optimization schemes based on optimal Delaunay
// triangulations", section 3]: the node goes to the centre of mass of its star,
//     x* = sum_t |t| b_t / sum_t |t|,  b_t the barycentre of t.
// A weighted mean of places inside, so it never blows up.
#include "geometry/measures.h"
#include "relax/method.h"

namespace crumple::relax {

Vec3 target_cpt(const Star& star) {
    const Vec3 origin = star.mesh.positions[star.node];
    Vec3 moment;
    double volume = 0;
    for (const Index t : star.tets) {
        const auto& [a, b, c, d] = star.mesh.tets[t];
        const auto& p = star.mesh.positions;
        const double share = signed_volume(p[a], p[b], p[c], p[d]);
        moment += ((p[a] - origin) + (p[b] - origin) + (p[c] - origin) + (p[d] - origin)) * (share / 4);
        volume += share;
    }
    return origin + moment / volume;
}

}
