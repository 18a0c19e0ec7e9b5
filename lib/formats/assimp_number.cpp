// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/assimp_number.h"

#include <assimp/fast_atof.h>

#include <array>
#include <cmath>
#include <limits>

namespace crumple::formats {

namespace {

// assimp multiplies by powf(10, exponent) in float: a few ulp off, never more than this.
constexpr float assimp_error = 1e-5f;

// What the parser throws; assimp's own exception type is not exported from the library.
struct NoNumber {
    template <class... Parts>
    explicit NoNumber(Parts&&...) {}
};

}

std::optional<float> as_assimp_reads(std::string_view word) {
    std::array<char, 64> text{};  // the parser wants an end
    if (word.size() >= text.size()) return std::nullopt;
    word.copy(text.data(), word.size());
    try {
        return Assimp::fast_atof<NoNumber>(text.data());
    } catch (const NoNumber&) {
        return std::nullopt;
    }
}

bool is_same_number(float exact, float read) {
    // Below the least normal float assimp's digits are few.
    const float least = std::numeric_limits<float>::min();
    return exact == read || std::fabs(exact - read) <= assimp_error * std::fmax(std::fabs(exact), least / assimp_error);
}

bool is_misread(std::string_view word, double value) {
    const auto read = as_assimp_reads(word);
    if (!read) return false;
    if (std::isnan(value)) return !std::isnan(*read);
    constexpr double most = std::numeric_limits<float>::max();
    const auto infinity = std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(value > 0 ? 1 : -1));
    return !is_same_number(std::fabs(value) > most ? infinity : static_cast<float>(value), *read);
}

}
