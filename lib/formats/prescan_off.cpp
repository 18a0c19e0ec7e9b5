// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <charconv>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "formats/coordinate.h"
#include "formats/prescan.h"
#include "formats/printable.h"
#include "formats/text.h"

namespace crumple::formats {

namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::bad_input, what); }

// assimp's reader drops polygons with more corners than this.
constexpr std::uint64_t max_corners = 9;

class Lines {
public:
    explicit Lines(std::string_view text) : left_(text) {}

    // The next line that says something, without its comment; false at the end.
    bool next(std::string_view& line) {
        while (!left_.empty()) {
            line = next_line(left_);
            ++number_;
            std::string_view rest = line;
            const std::string_view word = next_word(rest);
            if (word.empty() || word[0] == '#') continue;
            line = line.substr(0, line.find('#'));
            return true;
        }
        return false;
    }
    [[nodiscard]] std::string place() const { return "line " + std::to_string(number_) + ": "; }
    [[nodiscard]] std::size_t size_left() const { return left_.size(); }

private:
    std::string_view left_;
    std::size_t number_ = 0;
};

struct Header {
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
    std::string keyword;      // "COFF"
    std::size_t numbers = 3;  // of a vertex: 3, normal 3, colour 4, texture 2
    bool has_colors = false;
};

// [ST][C][N][4][n]OFF; assimp knows no other order. All begin with the position, which is all that a visual mesh needs.
Header read_keyword(std::string_view word, Purpose purpose) {
    Header header;
    header.keyword = word;
    if (!word.ends_with("OFF")) refuse("line 1: OFF is missing");
    word.remove_suffix(3);
    if (word.find_first_of("4n") != std::string_view::npos)
        refuse("line 1: " + in_quotes(header.keyword) + " is of another dimension; only 3D is read");
    if (word.find_first_not_of("STCN") != std::string_view::npos)
        refuse("line 1: " + in_quotes(header.keyword) + " is no word of OFF; write OFF or COFF");
    const bool has_normals = word.find('N') != std::string_view::npos;
    header.has_colors = word.find('C') != std::string_view::npos;
    if (header.has_colors && has_normals && purpose == Purpose::shell) {
        refuse("line 1: " + in_quotes(header.keyword) +
               ": programs disagree whether normals or colours come first; export COFF, without normals");
    }
    header.numbers += (has_normals ? 3 : 0) + (header.has_colors ? 4 : 0);
    if (word.starts_with("ST")) header.numbers += 2;
    return header;
}

Header read_header(Lines& lines, Purpose purpose) {
    std::string_view line;
    if (!lines.next(line)) refuse("the file is empty");
    std::string_view rest = line;
    Header header = read_keyword(next_word(rest), purpose);
    line = rest;
    if (next_word(rest).empty()) {
        if (!lines.next(line)) refuse("the counts are missing");
    }
    rest = line;
    const std::string_view first = next_word(rest);
    if (first == "BINARY") refuse("line 1: binary OFF is not read; export OFF as text");
    const auto vertices = to_number<std::uint64_t>(first);
    const auto faces = to_number<std::uint64_t>(next_word(rest));
    if (!vertices || !faces) refuse(lines.place() + "the counts of vertices and faces are not numbers");
    header.vertices = *vertices;
    header.faces = *faces;
    return header;
}

// Numbers that the keyword does not announce may be colours, and so locks; colours that are missing make assimp fail.
void check_number_count(std::string_view line, const Header& header, const Lines& lines) {
    std::size_t count = 0;
    while (!next_word(line).empty()) ++count;
    if (count == header.numbers) return;
    const std::string have = lines.place() + "a vertex of " + std::to_string(count) + " numbers, where " +
                             in_quotes(header.keyword) + " has " + std::to_string(header.numbers);
    refuse(have + (header.has_colors ? " (x y z red green blue alpha, all of them on each line)"
                                     : "; if the others are colours, line 1 must say COFF and each vertex have x y z "
                                       "red green blue alpha"));
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

// The four numbers of a vertex's colour, one blank behind each; the red goes to `red`.
std::string read_color(std::string_view line, const Lines& lines, float& red) {
    for (int axis = 0; axis < 3; ++axis) (void)next_word(line);
    std::string color;
    for (int channel = 0; channel < 4; ++channel) {
        const std::string_view word = next_word(line);
        const auto value = to_number<double>(word);  // not to_real: assimp reads "-1.#IND" as -1
        if (!value) refuse(lines.place() + "the colour " + in_quotes(word) + " is not a number");
        if (channel == 0) red = static_cast<float>(*value);
        color.append(word) += ' ';
    }
    return color;
}

// Leaves the line behind the corners.
std::vector<std::uint64_t> read_polygon(std::string_view& line, const Lines& lines, const Header& header) {
    const auto count = to_number<std::uint64_t>(next_word(line));
    if (!count || *count == 0) refuse(lines.place() + "the number of corners of a face is missing");
    if (*count > max_corners) {
        refuse(lines.place() + "a face of " + std::to_string(*count) + " corners; split faces of more than " +
               std::to_string(max_corners));
    }
    std::vector<std::uint64_t> corners;
    for (std::uint64_t i = 0; i < *count; ++i) {
        const auto vertex = to_number<std::uint64_t>(next_word(line));
        if (!vertex || *vertex >= header.vertices) {
            refuse(lines.place() + "corner " + std::to_string(i) + " of a face refers to no vertex");
        }
        corners.push_back(*vertex);
    }
    return corners;
}

// What is a surface and a shell's paint, written as OFF again: assimp takes comments for vertices and faces, and
// refuses odd colours where nobody needs them.
class PlainOff {
public:
    PlainOff(const Header& header, bool has_colors)
        : text_((has_colors ? "COFF\n" : "OFF\n") + std::to_string(header.vertices) + " " +
                std::to_string(header.faces) + " 0\n") {}

    // color: its words as the file has them, by which assimp tells bytes from shares; may be empty.
    void add_vertex(Vec3f position, std::string_view color) {
        for (int axis = 0; axis < 3; ++axis) append(position[axis], ' ');
        text_.append(color);
        text_.back() = '\n';
    }
    void add_face(const std::vector<std::uint64_t>& corners) {
        append(corners.size(), ' ');
        for (const std::uint64_t corner : corners) append(corner, ' ');
        text_.back() = '\n';
    }
    [[nodiscard]] std::string take() { return std::move(text_); }

private:
    template <class Number>
    void append(Number number, char after) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
        text_.append(digits.data(), end);
        text_ += after;
    }

    std::string text_;
};

void check_counts(const Header& header, const Lines& lines) {
    constexpr std::size_t shortest_line = 6;  // "0 0 0\n"
    if (header.vertices <= lines.size_left() / shortest_line + 1 && header.faces <= lines.size_left() / 2 + 1) return;
    refuse("the header announces " + std::to_string(header.vertices) + " vertices and " + std::to_string(header.faces) +
           " faces, more than the file can hold");
}

}

Prescan prescan_off(std::string_view text, Purpose purpose) {
    Lines lines(text);
    const Header header = read_header(lines, purpose);
    check_counts(header, lines);
    const bool reads_colors = header.has_colors && purpose == Purpose::shell;
    PlainOff plain(header, reads_colors);
    Prescan result;
    std::string_view line;
    for (std::uint64_t v = 0; v < header.vertices; ++v) {
        if (!lines.next(line))
            refuse("the file ends after " + std::to_string(v) + " of " + std::to_string(header.vertices) + " vertices");
        if (purpose == Purpose::shell) check_number_count(line, header, lines);
        result.positions.push_back(read_position(line, lines));
        std::string color;
        if (reads_colors) color = read_color(line, lines, result.reds.emplace_back());
        plain.add_vertex(result.positions.back(), color);
    }
    for (std::uint64_t f = 0; f < header.faces; ++f) {
        if (!lines.next(line))
            refuse("the file ends after " + std::to_string(f) + " of " + std::to_string(header.faces) + " faces");
        const std::vector<std::uint64_t> corners = read_polygon(line, lines, header);
        if (corners.size() > 2) result.expected_triangles += corners.size() - 2;
        if (!next_word(line).empty()) ++result.unread.colored_faces;
        plain.add_face(corners);
    }
    result.surface_only = plain.take();
    return result;
}

}
