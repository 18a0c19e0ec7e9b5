// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string>
#include <unordered_set>

#include "core/error.h"
#include "importer/assimp_number.h"
#include "importer/coordinate.h"
#include "importer/paint.h"
#include "importer/prescan.h"
#include "importer/printable.h"
#include "importer/text.h"

namespace crumple::importer {

namespace {

[[noreturn]] void refuse(std::size_t line, const std::string& what) {
    throw Error(ErrorKind::bad_input, "line " + std::to_string(line) + ": " + what);
}

// A line of OBJ, with the lines a backslash joins to it.
class Lines {
public:
    explicit Lines(std::string_view text) : left_(text) {}

    bool next(std::string_view& line) {
        number_ += joined_;
        joined_ = 0;
        if (left_.empty()) return false;
        line = take();
        if (line.empty() || line.back() != '\\') return true;
        buffer_.clear();
        while (!line.empty() && line.back() == '\\') {
            buffer_.append(line.substr(0, line.size() - 1)).push_back(' ');
            line = left_.empty() ? std::string_view{} : take();
        }
        buffer_.append(line);
        line = buffer_;
        return true;
    }
    [[nodiscard]] std::size_t number() const { return number_ + 1; }  // of the first of the joined lines

private:
    std::string_view take() {
        ++joined_;
        return next_line(left_);
    }
    std::string_view left_;
    std::string buffer_;
    std::size_t number_ = 0;
    std::size_t joined_ = 0;
};

struct VertexLine {
    std::array<std::string_view, 7> words;  // 7: one more than any good line has
    std::size_t count = 0;
};

VertexLine split(std::string_view line) {
    VertexLine result;
    for (std::string_view word = next_word(line); !word.empty() && word[0] != '#'; word = next_word(line)) {
        if (result.count < result.words.size()) result.words[result.count] = word;
        ++result.count;
    }
    return result;
}

Vec3f exact_position(const VertexLine& vertex, std::size_t line) {
    Vec3f position;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = vertex.words[static_cast<std::size_t>(axis)];
        // Through double: a number too small for a float is 0, not an error.
        const auto value = to_number<double>(word);
        if (!value) refuse(line, in_quotes(word) + " is not a number");
        if (const auto fault = coordinate_fault(*value); !fault.empty())
            refuse(line, "coordinate " + in_quotes(word) + " " + std::string(fault));
        position[axis] = static_cast<float>(*value);
    }
    return position;
}

Vec3f assimp_position(const VertexLine& vertex, Vec3f exact) {
    Vec3f position;
    for (int axis = 0; axis < 3; ++axis) {
        position[axis] = as_assimp_reads(vertex.words[static_cast<std::size_t>(axis)]).value_or(exact[axis]);
    }
    return position;
}

bool is_one(std::string_view word) { return to_number<double>(word) == 1.0; }

// x y z; with a weight of 1; with a colour; with a colour and alpha.
bool fits_a_visual(const VertexLine& vertex) {
    return vertex.count == 3 || (vertex.count == 4 && is_one(vertex.words[3])) || vertex.count == 6 ||
           vertex.count == 7;
}

void check_number_count(const VertexLine& vertex, std::size_t& first_count, std::size_t line, Purpose purpose) {
    const std::size_t count = vertex.count;
    if (purpose == Purpose::visual && fits_a_visual(vertex)) return;
    const std::string have = "a `v` line of " + std::to_string(count) + " numbers";
    if (count != 3 && count != 6) {
        refuse(line, have + "; write x y z, or x y z red green blue on every one (alpha is not read)");
    }
    if (first_count == 0) first_count = count;
    if (count != first_count) {
        refuse(line, have + " where the first has " + std::to_string(first_count) +
                         "; give every vertex a colour or none, or vertices without one would count as locked");
    }
}

// Faces may refer to vertices that come later, so the largest number is compared at the end.
class Faces {
public:
    // Returns the number of triangles of an `f` line.
    std::uint64_t read(std::string_view text, std::size_t line, std::size_t vertices_so_far) {
        std::uint64_t corners = 0;
        for (std::string_view word = next_word(text); !word.empty() && word[0] != '#'; word = next_word(text)) {
            check_corner(word, line, vertices_so_far);
            ++corners;
        }
        if (corners < 3) {
            refuse(line, "an `f` line of " + std::to_string(corners) +
                             " corners; a face has at least 3 (the file may be cut short)");
        }
        return corners - 2;
    }

    void check_against(std::size_t vertex_count) const {
        if (largest_ > vertex_count) refuse_missing(std::to_string(largest_), line_of_largest_, vertex_count);
    }

private:
    void check_corner(std::string_view word, std::size_t line, std::size_t vertices_so_far) {
        const std::string_view number = word.substr(0, word.find('/'));
        const auto vertex = to_number<std::int64_t>(number);
        if (!vertex) refuse(line, in_quotes(word) + " is no corner of a face; write a vertex number");
        // Numbers below 0 count backwards from the last vertex.
        const bool is_before_first = *vertex < 0 && -*vertex > static_cast<std::int64_t>(vertices_so_far);
        if (*vertex == 0 || is_before_first) refuse_missing(std::string(number), line, vertices_so_far);
        if (*vertex > 0 && static_cast<std::uint64_t>(*vertex) > largest_) {
            largest_ = static_cast<std::uint64_t>(*vertex);
            line_of_largest_ = line;
        }
    }

    [[noreturn]] static void refuse_missing(const std::string& vertex, std::size_t line, std::size_t count) {
        refuse(line, "a face refers to vertex " + vertex + " of " + std::to_string(count) + "; the file is damaged");
    }

    std::uint64_t largest_ = 0;
    std::size_t line_of_largest_ = 0;
};

// assimp looks for a name among all it met so far, one by one. Counted are the names it compares.
class Names {
public:
    void read(std::string_view keyword, std::string_view name, std::size_t line) {
        std::unordered_set<std::string>& known = keyword == "o" ? objects_ : materials_;
        known.emplace(name);
        compared_ += known.size();
        if (compared_ <= most) return;
        refuse(line, "too many objects and materials (`o` and `usemtl` lines, so far " +
                         std::to_string(objects_.size()) + " and " + std::to_string(materials_.size()) +
                         " names); join objects before exporting, or name groups (`g`) instead");
    }

private:
    static constexpr std::uint64_t most = 400'000'000;  // some seconds
    std::unordered_set<std::string> objects_;
    std::unordered_set<std::string> materials_;
    std::uint64_t compared_ = 0;
};

// Statements of curves and surfaces that are not polygons [Wavefront, Advanced Visualizer manual, appendix B1].
bool is_free_form(std::string_view keyword) {
    for (const char* free_form : {"curv", "curv2", "surf", "bzp", "bsp", "cdc", "cdp"}) {
        if (keyword == free_form) return true;
    }
    return false;
}

void check_is_surface(const Prescan& scan) {
    if (scan.positions.empty()) throw Error(ErrorKind::bad_input, "no `v` line: this is no OBJ file with vertices");
    if (scan.expected_triangles > 0) return;
    throw Error(ErrorKind::bad_input, scan.unread.free_form > 0
                                          ? "it has no faces, only free-form curves and surfaces, which are not read; "
                                            "convert them to polygons"
                                          : "it has no faces, only points; a surface is needed");
}

// The red of a `v` line. One that assimp reads as something else would lock or free a vertex.
float red_of(const VertexLine& vertex, std::size_t line) {
    for (std::size_t i = 3; i < 6; ++i) {
        if (!to_number<double>(vertex.words[i]))
            refuse(line, "the colour " + in_quotes(vertex.words[i]) + " is not a number");
    }
    const auto red = static_cast<float>(*to_number<double>(vertex.words[3]));
    const auto read = as_assimp_reads(vertex.words[3]);
    if (!read || is_locked(*read) != is_locked(red))
        refuse(line,
               "the reader makes something else of the red " + in_quotes(vertex.words[3]) + "; write a plain number");
    return red;
}

// The vertices that a line of ZBrush's polypaint gives a colour: 8 digits each, MMRRGGBB.
std::uint64_t count_polypaint(std::string_view digits) {
    constexpr std::size_t digits_a_vertex = 8;
    return next_word(digits).size() / digits_a_vertex;
}

// The same file with nothing but x y z on its `v` lines: assimp knows fewer forms of them.
std::string without_paint(std::string_view text) {
    std::string plain;
    Lines lines(text);
    for (std::string_view line; lines.next(line);) {
        std::string_view rest = line;
        if (next_word(rest) != "v") {
            plain.append(line) += '\n';
            continue;
        }
        const VertexLine vertex = split(rest);
        plain += 'v';
        for (std::size_t axis = 0; axis < 3; ++axis) (plain += ' ').append(vertex.words[axis]);
        plain += '\n';
    }
    return plain;
}

}

Prescan prescan_obj(std::string_view text, Purpose purpose) {
    Prescan result;
    Lines lines(text);
    Faces faces;
    Names names;
    std::size_t first_count = 0;
    bool has_paint = false;
    for (std::string_view line; lines.next(line);) {
        if (line.find('\r') != std::string_view::npos)
            refuse(lines.number(), "a carriage return within the line; save the file with line feeds");
        const std::string_view keyword = next_word(line);
        if (keyword == "f") {
            result.expected_triangles += faces.read(line, lines.number(), result.positions.size());
        }
        if (keyword == "o" || keyword == "usemtl") names.read(keyword, line, lines.number());
        if (is_free_form(keyword)) ++result.unread.free_form;
        if (keyword == "#MRGB") result.unread.polypaint += count_polypaint(line);
        if (keyword != "v") continue;
        const VertexLine vertex = split(line);
        check_number_count(vertex, first_count, lines.number(), purpose);
        has_paint = has_paint || vertex.count > 3;
        result.positions.push_back(exact_position(vertex, lines.number()));
        result.assimp_positions.push_back(assimp_position(vertex, result.positions.back()));
        if (purpose == Purpose::shell && vertex.count == 6) result.reds.push_back(red_of(vertex, lines.number()));
    }
    faces.check_against(result.positions.size());
    check_is_surface(result);
    if (has_paint && purpose == Purpose::visual) result.surface_only = without_paint(text);
    return result;
}

}
