// SPDX-License-Identifier: MIT
// How long a step may be before nodes are too light for it.
#pragma once
#include <vector>

#include "bundle/bundle.h"

namespace crumple {

// N: seconds, infinite at nodes of no simulated tet. By too_light.h with tr(K'_ii) = sum of V |g_i|^2 (lambda + 4 mu),
// which is the same however the tets are turned. REQUIRES: a bundle that validate finds nothing wrong with.
[[nodiscard]] std::vector<double> longest_steps(const Bundle& bundle);

}
