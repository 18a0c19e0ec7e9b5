// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of vertices, and which of them lock one.
#pragma once
#include <array>
#include <cmath>

namespace crumple::formats {

using Color = std::array<float, 4>;  // red, green, blue, alpha

// Half of the smallest red an 8-bit picture can hold above 0: 8-bit red 1 is not locked, 16-bit red 1 is.
inline constexpr float locked_below = 0.5f / 255;

// Of a stored red. What is no finite number locks nothing.
[[nodiscard]] inline bool is_locked(float red) { return std::isfinite(red) && red < locked_below; }

}
