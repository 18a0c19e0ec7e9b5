// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the surface of the tets a 2-manifold where it touches itself along an edge or at a node, by taking away or
// adding the tets whose volume is least.
#pragma once
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "core/index.h"
#include "mesh/tet_mesh.h"

namespace crumple::finish {

struct RepairReport {
    std::uint64_t edges_before = 0;  // of the surface, with other than two faces
    std::uint64_t nodes_before = 0;  // where the surface is no single fan
    std::uint64_t nodes_left = 0;    // not to be mended without losing a shell vertex
    std::uint64_t removed = 0;       // tets
    std::uint64_t added = 0;
    double volume_removed = 0;  // cubic metres
    double volume_added = 0;
    std::vector<Index> places;  // nodes where the surface was changed, ascending
};

struct Repaired {
    TetMesh mesh;  // nodes as they came; tets that stay in their order, then the added ones; neighbours filled
    RepairReport report;
};

// A node of the shell never loses its last tet. REQUIRES: neighbours filled.
[[nodiscard]] Repaired repair_surface(TetMesh mesh, const Context& context);

}
