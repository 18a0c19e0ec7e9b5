// SPDX-License-Identifier: GPL-3.0-or-later
// Text from outside - names in files, paths, keys of a recipe - in messages for a terminal.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace crumple::report {

// One safe line: control characters, which could drive a terminal or turn the direction of text, and bytes that are not
// UTF-8 are told as \n, \t or \x1b.
[[nodiscard]] std::string printable(std::string_view text);

// What is longer than `longest` bytes loses its middle, and says so: "aaaa ... (100000 bytes) ... aaaa".
[[nodiscard]] std::string shortened(std::string_view text, std::size_t longest);

// Longest name, and longest whole message, that a person would read.
inline constexpr std::size_t longest_name = 80;
inline constexpr std::size_t longest_message = 1500;

}
