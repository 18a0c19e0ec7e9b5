// SPDX-License-Identifier: GPL-3.0-or-later
// An order of points in which neighbours in the list are neighbours in space: Morton's curve.
#pragma once
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple::bind {

// A permutation of the points. For speed only: nothing may depend on it. Positions must be finite.
[[nodiscard]] std::vector<Index> spatial_order(std::span<const Vec3> positions);

}
