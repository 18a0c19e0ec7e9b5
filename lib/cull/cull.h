// SPDX-License-Identifier: GPL-3.0-or-later
// Throws away tetrahedra outside the shell and the interior nodes nobody uses any more.
// Shell vertices keep their indices, so anything baked against the shell stays valid.
#pragma once
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"

namespace crumple::cull {

inline constexpr int version = 1;

struct Params {};
struct Report {};

struct Result {
    TetMesh mesh;  // with region filled
    Report report;
};

// Throws Error(bad_input) when no tet is left.
[[nodiscard]] Result cull_outside(const Shell& shell, TetMesh mesh, const Params& params = {}, const Context& context = {});

}
