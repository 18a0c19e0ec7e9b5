// SPDX-License-Identifier: MIT
#include "core/short_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace crumple {

namespace {

std::string written(double number, std::chars_format format, int precision) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number, format, precision);
    return {text.data(), end.ptr};
}

}

std::string short_text(double number, int digits) {
    const std::string general = written(number, std::chars_format::general, digits);
    const std::size_t e = general.find('e');
    if (e == std::string::npos) return general;
    const int exponent = std::atoi(general.c_str() + e + 1);
    if (exponent < -6 || exponent >= 9) return general;
    std::string fixed = written(number, std::chars_format::fixed, std::max(0, digits - 1 - exponent));
    if (fixed.find('.') == std::string::npos) return fixed;
    fixed.erase(fixed.find_last_not_of('0') + 1);
    if (fixed.back() == '.') fixed.pop_back();
    return fixed;
}

std::string percent_text(double share) { return short_text(100 * share) + " %"; }

std::string position_text(Vec3 place) {
    constexpr int digits = 6;
    std::string text = "(";
    for (int axis = 0; axis < 3; ++axis) text += (axis > 0 ? ", " : "") + short_text(place[axis], digits);
    return text + ")";
}

}
