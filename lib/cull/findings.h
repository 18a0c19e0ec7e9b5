// SPDX-License-Identifier: GPL-3.0-or-later
// Says in words and places what the figures of a cull mean.
#pragma once
#include <vector>

#include "cull/cull.h"
#include "cull/fidelity.h"
#include "cull/shell_solid.h"
#include "mesh/boundary.h"

namespace crumple::cull {

struct Evidence {
    const Shell& shell;
    const ShellSolid& solid;
    const Fidelity& fidelity;
    const TetMesh& mesh;  // after culling
    const NonManifold& non_manifold;
    const std::vector<Index>& unused_vertices;
};

[[nodiscard]] std::vector<Finding> describe_findings(const Report& report, const Evidence& evidence);

// Shell vertices that no tet uses; vertices no triangle uses are not asked for. Ascending.
[[nodiscard]] std::vector<Index> unused_shell_vertices(const Shell& shell, const TetMesh& mesh);

// V: the component a shell vertex belongs to, none for a vertex without triangle.
[[nodiscard]] std::vector<Index> vertex_components(const Shell& shell);

}
