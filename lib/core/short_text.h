// SPDX-License-Identifier: MIT
// Numbers and places as messages tell them: few digits, "100" rather than "1e+02", no locale.
#pragma once
#include <string>

#include "core/vec3.h"

namespace crumple {

// So many significant digits at most, and all digits before the point; an exponent only below 1e-6 and from 1e9 on.
[[nodiscard]] std::string short_text(double number, int digits = 3);

// "2.5 %" for 0.025.
[[nodiscard]] std::string percent_text(double share);

// "(0.5, 1, -2.25)".
[[nodiscard]] std::string position_text(Vec3 place);

}
