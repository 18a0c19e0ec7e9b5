// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/printable.h"

#include "core/utf8.h"

namespace crumple::formats {

std::string printable(std::string_view name) {
    std::string result;
    while (!name.empty()) {
        const std::size_t size = utf8_size(name);
        if (result.size() + (size == 0 ? 1 : size) > max_name_bytes) break;
        if (size == 0 || is_control(name.substr(0, size))) {
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
