// SPDX-License-Identifier: GPL-3.0-or-later
// Lloyd's relaxation towards a centroidal Voronoi tessellation [Du, Faber, Gunzburger 1999, "Centroidal Voronoi
// tessellations"]: the node goes to the centre of mass of its Voronoi cell. The cell is summed exactly from signed
// simplices (node, middle of an edge, centre of a face, centre of a tet). Where the cell reaches outside the shell, or
// slivers drown it in rounding, the centre of the star stands in for it.
#include <algorithm>
#include <array>

#include "geometry/measures.h"
#include "relax/method.h"

namespace crumple::relax {

namespace {

struct Mass {
    double volume = 0;
    Vec3 moment;

    // The simplex (0, a, b, c).
    void add(Vec3 a, Vec3 b, Vec3 c, double sign) {
        const double share = sign * dot(a, cross(b, c)) / 6;
        volume += share;
        moment += (a + b + c) * (share / 4);
    }
};

// Centres of the circle and sphere through the origin and the given corners.
Vec3 face_centre(Vec3 u, Vec3 v) {
    const Vec3 normal = cross(u, v);
    return (cross(v, normal) * dot(u, u) + cross(normal, u) * dot(v, v)) / (2 * dot(normal, normal));
}
Vec3 tet_centre(Vec3 u, Vec3 v, Vec3 w) {
    return (cross(v, w) * dot(u, u) + cross(w, u) * dot(v, v) + cross(u, v) * dot(w, w)) / (2 * dot(u, cross(v, w)));
}

// What the tet (0, u, v, w), positive, holds of the origin's cell.
void add_part(Mass& mass, Vec3 u, Vec3 v, Vec3 w) {
    const Vec3 corners[] = {u, v, w};
    const Vec3 centre = tet_centre(u, v, w);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 from = corners[i];
        const Vec3 to = corners[(i + 1) % 3];
        const Vec3 of_face = face_centre(from, to);
        mass.add(from * 0.5, of_face, centre, 1);
        mass.add(to * 0.5, of_face, centre, -1);
    }
}

// The tet's other corners, in an order that keeps it positive with the node first.
std::array<Index, 3> others(const Tet& tet, Index node) {
    for (int corner = 0; corner < 4; ++corner) {
        if (tet[static_cast<std::size_t>(corner)] != node) continue;
        const auto& face = tet_face_corners[corner];
        return {tet[static_cast<std::size_t>(face[0])], tet[static_cast<std::size_t>(face[1])],
                tet[static_cast<std::size_t>(face[2])]};
    }
    return {};
}

}

Vec3 target_lloyd(const Star& star) {
    if (!star.is_whole) return target_cpt(star);
    const Vec3 origin = star.mesh.positions[star.node];
    Mass mass;
    double radius = 0;
    double star_volume = 0;
    for (const Index t : star.tets) {
        const auto [a, b, c] = others(star.mesh.tets[t], star.node);
        const Vec3 u = star.mesh.positions[a] - origin;
        const Vec3 v = star.mesh.positions[b] - origin;
        const Vec3 w = star.mesh.positions[c] - origin;
        add_part(mass, u, v, w);
        radius = std::max({radius, length(u), length(v), length(w)});
        star_volume += dot(u, cross(v, w)) / 6;
    }
    const Vec3 shift = mass.moment / mass.volume;
    // A cell fills about a quarter of its star.
    const bool is_sound = mass.volume > 0 && mass.volume < star_volume && length(shift) < radius;
    return is_sound ? origin + shift : target_cpt(star);
}

}
