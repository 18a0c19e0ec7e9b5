// SPDX-License-Identifier: GPL-3.0-or-later
// The values of one node of an FBX file, as text or binary has them.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace crumple::formats::fbx {

// A value of a binary file: a scalar or string of `type` and its bytes, or an array, perhaps compressed.
struct BinaryValue {
    char type =
        0;  // C B: byte; Y: 16 bits; I L: 32 and 64; F D: float and double; S R: text and bytes; f d i l b c: arrays
    std::string_view bytes;
    std::uint32_t count = 0;  // of an array's numbers
    bool is_compressed = false;
};

// Moves values behind the one returned; nothing where they end or are damaged.
[[nodiscard]] std::optional<BinaryValue> next_value(std::string_view& values);

[[nodiscard]] bool is_array(const BinaryValue& value);

// A scalar; nothing for text and arrays.
[[nodiscard]] std::optional<double> number_in(const BinaryValue& value);

// An array's numbers; nothing where its bytes do not give as many as it announces.
[[nodiscard]] std::optional<std::vector<double>> numbers_in(const BinaryValue& value);

// The next of the values that commas separate in text, without blanks around it, quotes included; values are moved
// behind it. Empty at the end.
[[nodiscard]] std::string_view next_word_of(std::string_view& values);

}
