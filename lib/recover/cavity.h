// SPDX-License-Identifier: GPL-3.0-or-later
// A polyhedron of tets to be filled anew by a cone: all its faces joined to one node.
#pragma once
#include <vector>

#include "core/index.h"
#include "core/vec3.h"
#include "mesh/tet_complex.h"

namespace crumple::recover {

struct Cavity {
    std::vector<Index> tets;
    std::vector<Triangle> faces;  // its surface, counter-clockwise seen from outside
};

[[nodiscard]] Triangle outward_face(const Tet& tet, int corner);

[[nodiscard]] inline bool has_corner(const Triangle& face, Index v) {
    return face[0] == v || face[1] == v || face[2] == v;
}

// An apex from which every face of a cavity is seen from inside, exactly.
struct Filling {
    Index node = none;   // a node of the cavity's surface
    Vec3 place;          // of a new node when there is none of these
    double quality = 0;  // of the worst tet; <= 0 when there is no filling at all
};

// Prefers a node of the surface unless it makes much flatter tets than a new one. `seed`: a place in or on the cavity,
// from where to look for a new node's.
[[nodiscard]] Filling best_filling(const TetComplex& complex, const Cavity& cavity, Vec3 seed);

// The tets that join the faces without the apex to it.
void append_cone(const Cavity& cavity, Index apex, std::vector<Tet>& tets);

}
