// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a number that should be a coordinate.
#pragma once
#include <cmath>
#include <limits>
#include <string_view>

namespace crumple::formats {

// Empty for a number that a float can hold.
inline std::string_view coordinate_fault(double value) {
    if (std::isnan(value)) return "is not a number";
    if (std::isinf(value)) return "is not finite";
    if (std::fabs(value) > std::numeric_limits<float>::max()) return "is beyond the range of a float, 3.4e38";
    return {};
}

}
