// SPDX-License-Identifier: GPL-3.0-or-later
// The same task with nodes and tets in an order that follows from coordinates alone, so that whatever is decided in
// that order does not depend on how the input was numbered. Nodes at one place become one.
#pragma once
#include <vector>

#include "mesh/shell.h"
#include "mesh/tet_mesh.h"
#include "recover/constraints.h"

namespace crumple::recover {

struct Canonical {
    TetMesh mesh;
    Constraints constraints;
    std::vector<Index> original;  // of every canonical node: the one that the tets used, else the first at the place
};

[[nodiscard]] Canonical canonical_task(const TetMesh& mesh, const Shell& shell);

// The tets by their original nodes; of the nodes that were added those that some tet uses follow.
[[nodiscard]] TetMesh original_mesh(const Canonical& task, const TetMesh& canonical, const TetMesh& input);

}
