// SPDX-License-Identifier: GPL-3.0-or-later
// Where a shell is so thin that its two sides leave no room for a point between them: one layer of tets, and none of
// them better than the shape allows.
#pragma once
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "core/finding.h"
#include "mesh/shell.h"

namespace crumple::sample {

struct ThinParts {
    std::uint64_t triangles = 0;  // with the other side nearer than twice the clearance of a point
    double area_share = 0;        // of the surface of deformable material
    double least_thickness = 0;   // metres
    double least_ratio = 0;       // of thickness to the triangle's mean edge: no angle there exceeds its arctangent
    std::vector<Place> thinnest;  // by that ratio
};

// The thickness of a triangle is how far the other side is, straight through from its middle.
[[nodiscard]] ThinParts find_thin_parts(const Shell& shell, double clearance, const Context& context);

// SAMPLE_THIN: information, a warning where the least ratio is below 0.1. Nothing for a shell without thin parts.
[[nodiscard]] std::vector<Finding> describe_thin_parts(const ThinParts& thin);

}
