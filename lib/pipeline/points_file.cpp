// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/points_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include "core/error.h"
#include "store/read_file.h"

namespace crumple::pipeline {

namespace {

// Hands out the lines of a text, with their number for messages.
class Lines {
public:
    Lines(std::string_view text, std::string_view source) : text_(text), source_(source) {
        if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);  // byte order mark
    }
    bool next() {
        while (!text_.empty()) {
            const std::size_t end = std::min(text_.find('\n'), text_.size());
            line_ = text_.substr(0, end);
            text_.remove_prefix(std::min(end + 1, text_.size()));
            ++number_;
            const std::size_t first = line_.find_first_not_of(" \t\r");
            if (first == std::string_view::npos || line_[first] == '#') continue;
            line_.remove_prefix(first);
            return true;
        }
        return false;
    }
    [[nodiscard]] std::string_view line() const { return line_; }
    [[noreturn]] void refuse(const std::string& why) const {
        throw Error(ErrorKind::bad_input, std::string(source_) + ":" + std::to_string(number_) + ": " + why);
    }

private:
    std::string_view text_;
    std::string_view source_;
    std::string_view line_;
    std::size_t number_ = 0;
};

bool is_separator(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == ';'; }

// Takes the next word off the line; empty at its end.
std::string_view take_word(std::string_view& line) {
    while (!line.empty() && is_separator(line.front())) line.remove_prefix(1);
    std::size_t end = 0;
    while (end < line.size() && !is_separator(line[end])) ++end;
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
}

std::optional<double> number_of(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return number;
}

// Such as x,y,z: no word of it is a number.
bool is_heading(std::string_view line) {
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
        if (number_of(word)) return false;
    }
    return true;
}

Vec3 point_of(std::string_view line, const Lines& lines) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = take_word(line);
        const std::optional<double> number = number_of(word);
        if (word.empty()) lines.refuse("expected three numbers x y z, found " + std::to_string(axis));
        if (!number) lines.refuse("expected three numbers x y z, found '" + std::string(word.substr(0, 40)) + "'");
        if (!std::isfinite(*number)) lines.refuse("a coordinate is not finite");
        point[axis] = *number + 0.0;  // -0 becomes 0
    }
    return point;
}

std::size_t count_words(std::string_view line) {
    std::size_t count = 0;
    while (!take_word(line).empty()) ++count;
    return count;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "1,5 2,5 3,5": commas within numbers that something else separates. Read as six numbers it would be two wrong points.
bool has_decimal_commas(std::string_view line) {
    std::size_t numbers = 0;
    std::size_t with_comma = 0;
    while (!line.empty()) {
        const std::size_t end = std::min(line.find_first_of(" \t\r;"), line.size());
        const std::string_view word = line.substr(0, end);
        line.remove_prefix(std::min(end + 1, line.size()));
        const std::size_t comma = word.find(',');
        numbers += !word.empty();
        with_comma += comma != std::string_view::npos && comma > 0 && comma + 1 < word.size() &&
                      is_digit(word[comma - 1]) && is_digit(word[comma + 1]);
    }
    return numbers >= 3 && with_comma > 0;
}

// A line of x y z and nothing else: what more there is may be a colour or a fourth coordinate, who knows.
Vec3 whole_point_of(const Lines& lines) {
    if (has_decimal_commas(lines.line())) lines.refuse("numbers with decimal commas; write 1.5 for 1,5");
    const Vec3 point = point_of(lines.line(), lines);
    const std::size_t columns = count_words(lines.line());
    if (columns > 3) lines.refuse(std::to_string(columns) + " columns where x y z were expected; leave out the others");
    return point;
}

void add_point(PointSet& points, Vec3 point, const Lines& lines) {
    if (points.positions.size() + 1 >= none) lines.refuse("more points than 32 bits can number");
    points.positions.push_back(point);
}

std::optional<std::uint64_t> count_of(std::string_view line) {
    const std::string_view word = take_word(line);
    std::uint64_t count = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return count;
}

std::string extension_of(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return extension;
}

}

PointSet parse_points(std::string_view text, std::string_view source) {
    Lines lines(text, source);
    PointSet points;
    std::optional<std::uint64_t> promised;
    for (bool is_first = true; lines.next(); is_first = false) {
        const std::string_view rest = lines.line();
        if (is_first && count_words(rest) == 1 && (promised = count_of(rest))) continue;
        if (is_first && is_heading(rest)) continue;
        add_point(points, whole_point_of(lines), lines);
    }
    if (promised && *promised != points.positions.size()) {
        lines.refuse("the first line promises " + std::to_string(*promised) + " points, there are " +
                     std::to_string(points.positions.size()));
    }
    return points;
}

PointSet parse_obj_points(std::string_view text, std::string_view source) {
    Lines lines(text, source);
    PointSet points;
    while (lines.next()) {
        std::string_view rest = lines.line();
        if (take_word(rest) == "v") add_point(points, point_of(rest, lines), lines);
    }
    return points;
}

PointSet parse_node_points(std::string_view text, std::string_view source) {
    Lines lines(text, source);
    PointSet points;
    if (!lines.next()) lines.refuse("expected the number of points");
    const std::optional<std::uint64_t> promised = count_of(lines.line());
    if (!promised) lines.refuse("expected the number of points");
    while (points.positions.size() < *promised && lines.next()) {
        std::string_view rest = lines.line();
        (void)take_word(rest);  // its number
        add_point(points, point_of(rest, lines), lines);
    }
    if (points.positions.size() != *promised) lines.refuse("the file ends before its last point");
    return points;
}

bool is_points_file(const std::string& path) {
    static constexpr std::array<std::string_view, 7> extensions{".xyz", ".txt", ".pts", ".csv",
                                                                ".tsv", ".obj", ".node"};
    return std::find(extensions.begin(), extensions.end(), extension_of(path)) != extensions.end();
}

PointSet read_points_file(const std::string& path) {
    const std::vector<std::byte> bytes = store::read_file(path);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::string extension = extension_of(path);
    if (extension == ".obj") return parse_obj_points(text, path);
    if (extension == ".node") return parse_node_points(text, path);
    return parse_points(text, path);
}

}
