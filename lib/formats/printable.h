// SPDX-License-Identifier: GPL-3.0-or-later
// Names from files may hold any bytes; in ours they are short, printable UTF-8, so that a message or JSON can show
// them.
#pragma once
#include <string>
#include <string_view>

namespace crumple::formats {

inline constexpr std::size_t max_name_bytes = 200;

// Control characters and bytes that are not UTF-8 become '?'; what is longer is cut between characters.
[[nodiscard]] std::string printable(std::string_view name);

// A word of a file for a message: printable, in quotes, no longer than a message bears.
[[nodiscard]] std::string in_quotes(std::string_view word);

}
