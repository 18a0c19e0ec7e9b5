// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of a tet mesh, and where it is not a surface.
#pragma once
#include <span>
#include <vector>

#include "core/index.h"
#include "mesh/tet_mesh.h"

namespace crumple {

struct Boundary {
    std::vector<Triangle> faces;  // B, counter-clockwise seen from outside; in the order of tets, then corners
    std::vector<Index> tet;       // B: whose face it is
};

// REQUIRES: mesh.neighbours is filled.
[[nodiscard]] Boundary boundary_of(const TetMesh& mesh);

// Places where a closed triangle surface is no 2-manifold.
struct NonManifold {
    std::vector<Edge> edges;      // shared by a number of triangles other than two; ascending
    std::vector<Index> vertices;  // whose triangles do not form one closed fan; ascending, ends of those edges included
};

[[nodiscard]] NonManifold non_manifold(std::span<const Triangle> faces);

// T: which piece a tet belongs to, pieces connected across faces and numbered by their first tet.
// REQUIRES: mesh.neighbours is filled.
[[nodiscard]] std::vector<Index> pieces_of(const TetMesh& mesh);

}
