// SPDX-License-Identifier: GPL-3.0-or-later
// Named rigid frames over clusters of control nodes, chosen by the recipe.
#pragma once
#include "bake/bake.h"

namespace crumple::bake {

// Weights are shares of mass, so the origin is the cluster's centre of mass; nodes without mass carry no sensor.
// A sensor whose choice is empty is left out with a finding.
// REQUIRES: the bundle's nodes, tets, regions and masses are filled; check_params(params).
[[nodiscard]] std::vector<BundleSensor> bake_sensors(const Shell& shell, const Bundle& bundle, const Params& params,
                                                     std::vector<Finding>& findings);

}
