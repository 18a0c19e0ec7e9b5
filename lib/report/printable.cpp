// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/printable.h"

#include "core/utf8.h"

namespace crumple::report {

namespace {

std::string escaped(unsigned char byte) {
    constexpr char digits[] = "0123456789abcdef";
    if (byte == '\n') return "\\n";
    if (byte == '\t') return "\\t";
    if (byte == '\r') return "\\r";
    return {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
}

bool is_inside_character(std::string_view text, std::size_t at) {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80;
}

}

std::string printable(std::string_view text) {
    std::string line;
    line.reserve(text.size());
    while (!text.empty()) {
        const std::size_t size = utf8_size(text);
        const std::string_view character = text.substr(0, size == 0 ? 1 : size);
        if (size == 0 || is_control(character)) {
            for (const char c : character) line += escaped(static_cast<unsigned char>(c));
        } else {
            line += character;
        }
        text.remove_prefix(character.size());
    }
    return line;
}

std::string shortened(std::string_view text, std::size_t longest) {
    if (text.size() <= longest) return std::string(text);
    const std::string middle = " ... (" + std::to_string(text.size()) + " bytes) ... ";
    std::size_t head = longest * 2 / 3;
    while (is_inside_character(text, head)) --head;
    std::size_t tail = text.size() - longest / 6;
    while (is_inside_character(text, tail)) ++tail;
    return std::string(text.substr(0, head)) + middle + std::string(text.substr(tail));
}

}
