// SPDX-License-Identifier: MIT
// What someone who mistyped a name most likely meant.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace crumple {

// The valid name with the fewest edits (insert, delete, replace, swap neighbours; case is free); the first of equals,
// empty when there are none.
[[nodiscard]] std::string nearest_name(std::string_view word, std::span<const std::string> valid);

// "a, b, c", cut after the first few.
[[nodiscard]] std::string list_names(std::span<const std::string> names);

}
