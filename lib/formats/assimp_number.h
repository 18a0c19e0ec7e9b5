// SPDX-License-Identifier: GPL-3.0-or-later
// A number of a text file as assimp's own parser reads it: up to a few ulp off the nearest float. By this value what it
// delivers is recognized again.
#pragma once
#include <optional>
#include <string_view>

namespace crumple::formats {

// Nothing where assimp would not see a number either.
[[nodiscard]] std::optional<float> as_assimp_reads(std::string_view word);

// Whether assimp's parser can have made `read` of the number whose nearest float is `exact`.
[[nodiscard]] bool is_same_number(float exact, float read);

// Whether assimp makes quite another number of the word than its value: 0 of 99999999999999999999, say.
[[nodiscard]] bool is_misread(std::string_view word, double value);

}
