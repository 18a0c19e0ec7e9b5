// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/printable.h"

#include <cstdint>

namespace crumple::importer {

namespace {

bool is_continuation(unsigned char c) { return (c & 0xc0) == 0x80; }

// Bytes of the well-formed character at the start of text, 0 where there is none [Unicode 15, table 3-7].
std::size_t character_size(std::string_view text) {
    const auto at = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const unsigned first = at(0);
    if (first < 0x80) return 1;
    const std::size_t size = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
    for (std::size_t i = 1; i < size; ++i) {
        if (!is_continuation(static_cast<unsigned char>(at(i)))) return 0;
    }
    const bool overlong = (first == 0xe0 && at(1) < 0xa0) || (first == 0xf0 && at(1) < 0x90);
    const bool surrogate_or_beyond = (first == 0xed && at(1) > 0x9f) || (first == 0xf4 && at(1) > 0x8f);
    return overlong || surrogate_or_beyond ? 0 : size;
}

bool is_control(unsigned char c) { return c < 0x20 || c == 0x7f; }

}

std::string printable(std::string_view name) {
    std::string result;
    while (!name.empty()) {
        const std::size_t size = character_size(name);
        if (result.size() + (size == 0 ? 1 : size) > max_name_bytes) break;
        if (size == 0 || is_control(static_cast<unsigned char>(name[0]))) {
            result += '?';
        } else {
            result += name.substr(0, size);
        }
        name.remove_prefix(size == 0 ? 1 : size);
    }
    return result;
}

std::string in_quotes(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string result = "'";
    result += printable(word.substr(0, longest));
    result += word.size() > longest ? "...'" : "'";
    return result;
}

}
