// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>

#include "formats/assimp_number.h"
#include "formats/prescan.h"
#include "formats/text.h"

namespace crumple::formats {

namespace {

bool may_be_in_a_number(char c) {
    return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
}

}

Prescan prescan_numbers(std::string_view bytes) {
    Prescan result;
    if (bytes.find('\0') != std::string_view::npos) return result;  // not text
    for (std::size_t begin = 0; begin < bytes.size();) {
        std::size_t end = begin;
        while (end < bytes.size() && may_be_in_a_number(bytes[end])) ++end;
        const std::string_view word = bytes.substr(begin, end - begin);
        begin = end + 1;
        const auto exact = to_number<float>(word);
        const auto read = exact ? as_assimp_reads(word) : std::nullopt;
        if (read) result.numbers.push_back({*read, *exact});
    }
    const auto less = [](const ReadNumber& a, const ReadNumber& b) {
        return a.read != b.read ? a.read < b.read : a.exact < b.exact;
    };
    const auto same = [](const ReadNumber& a, const ReadNumber& b) { return a.read == b.read && a.exact == b.exact; };
    std::sort(result.numbers.begin(), result.numbers.end(), less);
    result.numbers.erase(std::unique(result.numbers.begin(), result.numbers.end(), same), result.numbers.end());
    return result;
}

}
