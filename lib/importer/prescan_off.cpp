// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "core/error.h"
#include "importer/coordinate.h"
#include "importer/prescan.h"
#include "importer/printable.h"
#include "importer/text.h"

namespace crumple::importer {

namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::bad_input, what); }

// assimp's reader drops polygons with more corners than this.
constexpr std::uint64_t max_corners = 9;

class Lines {
public:
    explicit Lines(std::string_view text) : left_(text) {}

    // The next line that says something; false at the end.
    bool next(std::string_view& line) {
        while (!left_.empty()) {
            line = next_line(left_);
            ++number_;
            std::string_view rest = line;
            const std::string_view word = next_word(rest);
            if (!word.empty() && word[0] != '#') return true;
        }
        return false;
    }
    [[nodiscard]] std::string place() const { return "line " + std::to_string(number_) + ": "; }
    [[nodiscard]] std::size_t size_left() const { return left_.size(); }

private:
    std::string_view left_;
    std::size_t number_ = 0;
};

struct Counts {
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
};

Counts read_header(Lines& lines) {
    std::string_view line;
    if (!lines.next(line)) refuse("the file is empty");
    std::string_view rest = line;
    const std::string_view keyword = next_word(rest);
    if (keyword.size() < 3 || keyword.substr(keyword.size() - 3) != "OFF") refuse("line 1: OFF is missing");
    if (keyword.find('4') != std::string_view::npos || keyword.find('n') != std::string_view::npos) {
        refuse("line 1: " + in_quotes(keyword) + " is of another dimension; only 3D is read");
    }
    if (next_word(rest).empty()) {
        if (!lines.next(line)) refuse("the counts are missing");
        rest = line;
    } else {
        rest = line;
        (void)next_word(rest);
    }
    const auto vertices = to_number<std::uint64_t>(next_word(rest));
    const auto faces = to_number<std::uint64_t>(next_word(rest));
    if (!vertices || !faces) refuse(lines.place() + "the counts of vertices and faces are not numbers");
    return {*vertices, *faces};
}

Vec3f read_position(std::string_view line, const Lines& lines) {
    Vec3f position;
    for (int axis = 0; axis < 3; ++axis) {
        const auto value = to_number<double>(next_word(line));
        if (!value) refuse(lines.place() + "three coordinates expected");
        if (const auto fault = coordinate_fault(*value); !fault.empty())
            refuse(lines.place() + "a coordinate " + std::string(fault));
        position[axis] = static_cast<float>(*value);
    }
    return position;
}

std::uint64_t read_polygon(std::string_view line, const Lines& lines, const Counts& counts) {
    const auto corners = to_number<std::uint64_t>(next_word(line));
    if (!corners || *corners == 0) refuse(lines.place() + "the number of corners of a face is missing");
    if (*corners > max_corners) {
        refuse(lines.place() + "a face of " + std::to_string(*corners) + " corners; split faces of more than " +
               std::to_string(max_corners));
    }
    for (std::uint64_t i = 0; i < *corners; ++i) {
        const auto vertex = to_number<std::uint64_t>(next_word(line));
        if (!vertex || *vertex >= counts.vertices) {
            refuse(lines.place() + "corner " + std::to_string(i) + " of a face refers to no vertex");
        }
    }
    return *corners < 3 ? 0 : *corners - 2;
}

}

Prescan prescan_off(std::string_view text) {
    Lines lines(text);
    const Counts counts = read_header(lines);
    constexpr std::size_t shortest_line = 6;  // "0 0 0\n"
    if (counts.vertices > lines.size_left() / shortest_line + 1 || counts.faces > lines.size_left() / 2 + 1) {
        refuse("the header announces " + std::to_string(counts.vertices) + " vertices and " +
               std::to_string(counts.faces) + " faces, more than the file can hold");
    }
    Prescan result;
    std::string_view line;
    for (std::uint64_t v = 0; v < counts.vertices; ++v) {
        if (!lines.next(line))
            refuse("the file ends after " + std::to_string(v) + " of " + std::to_string(counts.vertices) + " vertices");
        result.positions.push_back(read_position(line, lines));
    }
    for (std::uint64_t f = 0; f < counts.faces; ++f) {
        if (!lines.next(line))
            refuse("the file ends after " + std::to_string(f) + " of " + std::to_string(counts.faces) + " faces");
        result.expected_triangles += read_polygon(line, lines, counts);
    }
    return result;
}

}
