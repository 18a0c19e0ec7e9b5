// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the surface of the tets a 2-manifold where it touches itself along an edge or at a node: takes away or adds the
// tets of least volume, or gives the parts that touch a node each; where that is not enough, cuts them smaller first.
#pragma once
#include <cstdint>
#include <span>

#include "core/context.h"
#include "mesh/tet_mesh.h"

namespace crumple::finish {

struct RepairReport {
    std::uint64_t edges_before = 0;  // of the surface, with other than two faces
    std::uint64_t nodes_before = 0;  // where the surface is no single fan
    std::uint64_t nodes_left = 0;
    std::uint64_t removed = 0;  // tets
    std::uint64_t added = 0;
    std::uint64_t split = 0;    // nodes that parts no longer share
    std::uint64_t bent = 0;     // edges that parts were bent off
    std::uint64_t cut = 0;      // nodes whose tets were cut down to one tip
    double volume_removed = 0;  // cubic metres
    double volume_added = 0;
};

struct Repaired {
    TetMesh
        mesh;  // nodes as they came, then copies of split ones and new ones; tets in their order, then the added ones
    RepairReport report;
};

// A shell vertex never loses its last tet and a locked one (locked: by shell vertex, may be short) is never split.
// REQUIRES: neighbours filled.
[[nodiscard]] Repaired repair_surface(TetMesh mesh, std::span<const std::uint8_t> locked, const Context& context);

}
