// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles that limit how good any mesh of the shell can be, or show how it came to be open.
#pragma once
#include <vector>

#include "core/finding.h"
#include "mesh/shell.h"

namespace crumple::importer {

// SHELL_NEEDLE: triangles with a corner below 5 degrees, the sharpest first. SHELL_T_JUNCTION: vertices of open edges
// that lie on the middle of another open edge. SHELL_PINCHED: vertices where the triangles of one component form more
// than one fan. SHELL_NEARLY_DOUBLE: triangles whose middle lies nearly on another one.
[[nodiscard]] std::vector<Finding> find_flaws(const Shell& shell, double diagonal);

}
