// SPDX-License-Identifier: GPL-3.0-or-later
// Tetrahedra over nodes. V nodes (shell vertices first, at their shell index), T tets.
#pragma once
#include <array>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple {

struct TetMesh {
    std::vector<Vec3> positions;                  // V, metres, float-representable
    Index shell_vertex_count = 0;                 // nodes [0, shell_vertex_count) are the shell's and never move
    std::vector<Tet> tets;                        // T, orient3d > 0 exactly
    std::vector<std::array<Index, 4>> neighbours; // T: across the face opposite corner i, none at the boundary
    std::vector<Index> region;                    // T or empty before cull: shell component a tet lies in
};

}
