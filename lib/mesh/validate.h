// SPDX-License-Identifier: GPL-3.0-or-later
// Lists what is wrong with the plain data that stages hand to each other. Never reads out of bounds, whatever it holds.
#pragma once
#include <vector>

#include "core/finding.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"

namespace crumple {

// Findings of Severity::error with codes SHELL_* and TETS_*; empty when all is well. Says nothing about the shape: an
// open or crossing shell is valid data.
[[nodiscard]] std::vector<Finding> validate(const Shell& shell);

// Regions are checked against `component_count` unless it is none; a mesh before cull has no regions.
[[nodiscard]] std::vector<Finding> validate(const TetMesh& mesh, Index component_count = none);

}
