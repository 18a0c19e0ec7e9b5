// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "core/error.h"
#include "formats/color.h"
#include "formats/coordinate.h"
#include "formats/obj_surface.h"
#include "formats/prescan.h"
#include "formats/printable.h"
#include "formats/text.h"

namespace crumple::formats {

namespace {

[[noreturn]] void refuse(std::size_t line, const std::string& what) {
    throw Error(ErrorKind::bad_input, "line " + std::to_string(line) + ": " + what);
}

bool ends_in_a_comment(std::string_view line) {
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
        if (word[0] == '#') return true;
    }
    return false;
}

// A backslash at the end of a comment is a folder's, say.
bool goes_on(std::string_view line) { return !line.empty() && line.back() == '\\' && !ends_in_a_comment(line); }

// A line of OBJ, with the lines a backslash joins to it.
class Lines {
public:
    explicit Lines(std::string_view text) : left_(text) {}

    bool next(std::string_view& line) {
        number_ += joined_;
        joined_ = 0;
        if (left_.empty()) return false;
        line = take();
        if (!goes_on(line)) return true;
        buffer_.clear();
        while (goes_on(line)) {
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
    // The corners of an `f` line, from 0.
    std::span<const std::uint64_t> read(std::string_view text, std::size_t line, std::size_t vertices_so_far) {
        corners_.clear();
        for (std::string_view word = next_word(text); !word.empty() && word[0] != '#'; word = next_word(text))
            corners_.push_back(read_corner(word, line, vertices_so_far));
        if (corners_.size() < 3) {
            refuse(line, "an `f` line of " + std::to_string(corners_.size()) +
                             " corners; a face has at least 3 (the file may be cut short)");
        }
        return corners_;
    }

    void check_against(std::size_t vertex_count) const {
        if (largest_ > vertex_count) refuse_missing(std::to_string(largest_), line_of_largest_, vertex_count);
    }

private:
    std::uint64_t read_corner(std::string_view word, std::size_t line, std::size_t vertices_so_far) {
        const std::string_view number = word.substr(0, word.find('/'));
        const auto vertex = to_number<std::int64_t>(number);
        if (!vertex) refuse(line, in_quotes(word) + " is no corner of a face; write a vertex number");
        // Numbers below 0 count backwards from the last vertex.
        const std::int64_t from_1 = *vertex < 0 ? *vertex + static_cast<std::int64_t>(vertices_so_far) + 1 : *vertex;
        if (from_1 <= 0) refuse_missing(std::string(number), line, vertices_so_far);
        const auto corner = static_cast<std::uint64_t>(from_1);
        if (corner > largest_) {
            largest_ = corner;
            line_of_largest_ = line;
        }
        return corner - 1;
    }

    [[noreturn]] static void refuse_missing(const std::string& vertex, std::size_t line, std::size_t count) {
        refuse(line, "a face refers to vertex " + vertex + " of " + std::to_string(count) + "; the file is damaged");
    }

    std::vector<std::uint64_t> corners_;  // of the last line
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

Vec3f color_of(const VertexLine& vertex, std::size_t line) {
    Vec3f color;
    for (int channel = 0; channel < 3; ++channel) {
        const std::string_view word = vertex.words[static_cast<std::size_t>(3 + channel)];
        const auto value = to_number<double>(word);
        if (!value) refuse(line, "the colour " + in_quotes(word) + " is not a number");
        color[channel] = static_cast<float>(*value);
    }
    return color;
}

// The vertices that a line of ZBrush's polypaint gives a colour: 8 digits each, MMRRGGBB.
std::uint64_t count_polypaint(std::string_view digits) {
    constexpr std::size_t digits_a_vertex = 8;
    return next_word(digits).size() / digits_a_vertex;
}

// How many points or pieces of a polyline a `p` or `l` line has.
std::uint64_t count_pieces(std::string_view keyword, std::string_view rest) {
    const std::size_t words = split(rest).count;
    return keyword == "l" && words > 0 ? words - 1 : words;
}

bool parts_or_names(std::string_view keyword) {
    return keyword == "o" || keyword == "g" || keyword == "usemtl" || keyword == "mtllib";
}

// Reads the lines one by one and keeps what is a surface.
class Reader {
public:
    Reader(Purpose purpose, Prescan& result) : purpose_(purpose), result_(result) {}

    void read(std::string_view text) {
        Lines lines(text);
        for (std::string_view line; lines.next(line);) {
            if (line.find('\r') != std::string_view::npos)
                refuse(lines.number(), "a carriage return within the line; save the file with line feeds");
            const std::string_view keyword = next_word(line);
            read(keyword, line, lines.number());
        }
        faces_.check_against(result_.positions.size());
        check_is_surface(result_);
        result_.surface_only = surface_.take();
    }

private:
    void read(std::string_view keyword, std::string_view rest, std::size_t line) {
        if (keyword == "v") return read_vertex(split(rest), line);
        if (keyword == "f") return read_face(rest, line);
        if (keyword == "l" || keyword == "p") result_.unread.points_and_lines += count_pieces(keyword, rest);
        if (keyword == "o" || keyword == "usemtl") names_.read(keyword, rest, line);
        if (parts_or_names(keyword)) surface_.add_statement(keyword, rest);
        if (is_free_form(keyword)) ++result_.unread.free_form;
        if (keyword == "#MRGB") result_.unread.polypaint += count_polypaint(rest);
    }

    void read_vertex(const VertexLine& vertex, std::size_t line) {
        check_number_count(vertex, first_count_, line, purpose_);
        const Vec3f position = exact_position(vertex, line);
        std::optional<Vec3f> color;
        if (purpose_ == Purpose::shell && vertex.count == 6) color = color_of(vertex, line);
        const obj::AsRead read = surface_.add_vertex(position, color);
        if (color && is_locked(read.red) != is_locked(color->x))
            refuse(line, "the reader makes something else of the red " + in_quotes(vertex.words[3]) +
                             "; write 0 or a number well above it");
        result_.positions.push_back(position);
        result_.assimp_positions.push_back(read.position);
        if (color) result_.reds.push_back(color->x);
    }

    void read_face(std::string_view rest, std::size_t line) {
        const std::span<const std::uint64_t> corners = faces_.read(rest, line, result_.positions.size());
        result_.expected_triangles += corners.size() - 2;
        surface_.add_face(corners);
    }

    Purpose purpose_;
    Prescan& result_;
    std::size_t first_count_ = 0;
    Faces faces_;
    Names names_;
    obj::SurfaceWriter surface_;
};

}

Prescan prescan_obj(std::string_view text, Purpose purpose) {
    Prescan result;
    Reader(purpose, result).read(text);
    return result;
}

}
