// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a triangle surface parts inside from outside everywhere.
#pragma once
#include <span>

#include "core/index.h"

namespace crumple {

// Every edge is run through as often one way as the other: closed, and wound one way. Then the winding number is a
// whole number off the surface and changes only across it, however often the surface crosses itself.
[[nodiscard]] bool is_watertight(std::span<const Triangle> triangles);

}
