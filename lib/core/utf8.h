// SPDX-License-Identifier: MIT
// Text from outside may hold any bytes.
#pragma once
#include <cstddef>
#include <string_view>

namespace crumple {

// Bytes of the well-formed UTF-8 character at the start of the text, 0 where there is none [Unicode 15, table 3-7].
[[nodiscard]] std::size_t utf8_size(std::string_view text);

// Whether that character does something instead of showing: C0, delete and C1, which drive terminals; line and
// paragraph separators; marks that turn the direction of the text after them, so that a name reads as another [UAX #9,
// table 4].
[[nodiscard]] bool is_control(std::string_view character);

}
