// SPDX-License-Identifier: GPL-3.0-or-later
// The tets that are worst by some measure.
#pragma once
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple::quality {

[[nodiscard]] Vec3 centre_of(std::span<const Vec3> positions, const Tet& tet);

// The `count` tets of least value (T values), least first; ties by place.
[[nodiscard]] std::vector<Index> least_tets(std::span<const Vec3> positions, std::span<const Tet> tets,
                                            std::span<const double> values, std::size_t count);

}
