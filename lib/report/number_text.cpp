// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/number_text.h"

#include <array>
#include <charconv>

namespace crumple::report {

std::string number_text(double number, int digits) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits);
    return std::string(text.data(), end.ptr);
}

std::string float_text(float number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number);
    return std::string(text.data(), end.ptr);
}

std::string size_text(std::uint64_t bytes) {
    static constexpr std::array<const char*, 5> units{"kB", "MB", "GB", "TB", "PB"};
    if (bytes < 1000) return std::to_string(bytes) + " B";
    auto size = static_cast<double>(bytes) / 1000;
    std::size_t unit = 0;
    for (; size >= 999.5 && unit + 1 < units.size(); ++unit) size /= 1000;
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), size, std::chars_format::general, 3);
    return std::string(text.data(), end.ptr) + " " + units[unit];
}

}
