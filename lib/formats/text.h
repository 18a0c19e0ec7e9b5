// SPDX-License-Identifier: GPL-3.0-or-later
// Lines, words and numbers of text files. Views into the file's text; nothing is copied.
#pragma once
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>

namespace crumple::formats {

inline bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }

// The next word, and text moved behind it; empty at the end.
inline std::string_view next_word(std::string_view& text) {
    std::size_t begin = 0;
    while (begin < text.size() && is_space(text[begin])) ++begin;
    std::size_t end = begin;
    while (end < text.size() && !is_space(text[end])) ++end;
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

// The next line without its end, and text moved behind it.
inline std::string_view next_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

// The whole word as a number, correctly rounded; a leading + is allowed.
template <class Number>
std::optional<Number> to_number(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_whole = end == word.data() + word.size() && !word.empty();
    return error == std::errc{} && is_whole ? std::optional<Number>(value) : std::nullopt;
}

// The same, and what old C libraries of Windows print for what is no number ("-1.#IND", "1.#QNAN"), of which other
// readers make -1 or 1.
inline std::optional<double> to_real(std::string_view word) {
    const std::size_t mark = word.find("#");
    if (mark == std::string_view::npos || mark == 0 || word[mark - 1] != '.') return to_number<double>(word);
    const std::string_view what = word.substr(mark + 1, 3);
    if (what == "IND" || what == "QNA" || what == "SNA") return std::numeric_limits<double>::quiet_NaN();
    if (what != "INF") return std::nullopt;
    const double infinity = std::numeric_limits<double>::infinity();
    return word[0] == '-' ? -infinity : infinity;
}

}
