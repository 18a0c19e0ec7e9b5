// SPDX-License-Identifier: GPL-3.0-or-later
// What each shell component is made of.
#pragma once
#include <vector>

#include "bake/bake.h"

namespace crumple::bake {

struct ComponentMaterial {
    std::uint16_t material = 0;  // index into Params::materials
    float stiffness_scale = 1;
};

// One entry a component, one at least. Names in params that match no component become findings.
// REQUIRES: check_params(params).
[[nodiscard]] std::vector<ComponentMaterial> choose_materials(const Shell& shell, const Params& params,
                                                              std::vector<Finding>& findings);

}
