// SPDX-License-Identifier: GPL-3.0-or-later
// Where a triangle surface is open: closed walks along the edges that are run through more often one way than the
// other.
#pragma once
#include <span>
#include <vector>

#include "core/index.h"

namespace crumple {

// Each loop starts where it ends and runs the way its triangles do. Empty for a closed surface.
[[nodiscard]] std::vector<std::vector<Index>> boundary_loops(std::span<const Triangle> triangles);

}
