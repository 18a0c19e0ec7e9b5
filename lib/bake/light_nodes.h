// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes that the solver will have to make heavier because the game's steps are too long for float.
#pragma once
#include <vector>

#include "bundle/bundle.h"
#include "core/finding.h"

namespace crumple::bake {

// STEP_TOO_STIFF where a step of the solver at rest would warn of the same; places are nodes, the worst first.
// REQUIRES: the bundle is valid.
void warn_of_light_nodes(const Bundle& bundle, double step_s, std::vector<Finding>& findings);

}
