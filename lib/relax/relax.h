// SPDX-License-Identifier: GPL-3.0-or-later
// Moves interior nodes and triangulates again until the shapes are good. Shell vertices never move.
#pragma once
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"

namespace crumple::relax {

inline constexpr int version = 1;

struct Params {};
struct Report {};

struct Result {
    TetMesh mesh;  // Delaunay of the moved nodes, whole convex hull
    Report report;
};

// REQUIRES: mesh is the Delaunay tetrahedralization of its nodes, shell vertices first.
[[nodiscard]] Result relax_points(TetMesh mesh, const Shell& shell, const Params& params = {}, const Context& context = {});

}
