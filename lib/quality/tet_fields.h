// SPDX-License-Identifier: GPL-3.0-or-later
// Quality tet by tet, to colour a picture with.
#pragma once
#include <span>
#include <vector>

#include "core/context.h"
#include "core/index.h"
#include "core/vec3.h"

namespace crumple::quality {

// T each.
struct TetFields {
    std::vector<float> min_dihedral_deg;
    std::vector<float> volume_lrms3;        // 1 for a regular tet
    std::vector<float> element_step_ratio;  // over the step of a regular tet of the mean volume
};

[[nodiscard]] TetFields measure_fields(std::span<const Vec3> positions, std::span<const Tet> tets,
                                       const Context& context = {});

}
