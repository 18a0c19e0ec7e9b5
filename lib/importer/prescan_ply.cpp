// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>

#include "core/error.h"
#include "importer/coordinate.h"
#include "importer/prescan.h"
#include "importer/printable.h"
#include "importer/text.h"

namespace crumple::importer {

namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::bad_input, what); }

enum class Encoding { ascii, little, big };
enum class Kind { signed_integer, unsigned_integer, real };

struct Type {
    Kind kind;
    std::size_t size;
};

struct TypeName {
    std::string_view name;
    Type type;
};

constexpr TypeName type_names[] = {
    {"char", {Kind::signed_integer, 1}},
    {"int8", {Kind::signed_integer, 1}},
    {"uchar", {Kind::unsigned_integer, 1}},
    {"uint8", {Kind::unsigned_integer, 1}},
    {"short", {Kind::signed_integer, 2}},
    {"int16", {Kind::signed_integer, 2}},
    {"ushort", {Kind::unsigned_integer, 2}},
    {"uint16", {Kind::unsigned_integer, 2}},
    {"int", {Kind::signed_integer, 4}},
    {"int32", {Kind::signed_integer, 4}},
    {"uint", {Kind::unsigned_integer, 4}},
    {"uint32", {Kind::unsigned_integer, 4}},
    {"float", {Kind::real, 4}},
    {"float32", {Kind::real, 4}},
    {"double", {Kind::real, 8}},
    {"float64", {Kind::real, 8}},
};

struct Property {
    std::string name;
    Type type;                       // of the value, or of the list's values
    std::optional<Type> list_count;  // of a list's length
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    Encoding encoding = Encoding::ascii;
    std::vector<Element> elements;
};

Type type_of(std::string_view name) {
    for (const TypeName& entry : type_names) {
        if (entry.name == name) return entry.type;
    }
    refuse("the header names an unknown type " + in_quotes(name));
}

Encoding encoding_of(std::string_view name) {
    if (name == "ascii") return Encoding::ascii;
    if (name == "binary_little_endian") return Encoding::little;
    if (name == "binary_big_endian") return Encoding::big;
    refuse("the header names an unknown format " + in_quotes(name));
}

Property read_property(std::string_view line) {
    Property property;
    std::string_view word = next_word(line);
    if (word == "list") {
        property.list_count = type_of(next_word(line));
        if (property.list_count->kind == Kind::real) refuse("the header counts a list with a real number");
        word = next_word(line);
    }
    property.type = type_of(word);
    property.name = std::string(next_word(line));
    return property;
}

Element read_element(std::string_view line) {
    Element element;
    element.name = std::string(next_word(line));
    const auto count = to_number<std::uint64_t>(next_word(line));
    if (!count) refuse("the header does not say how many of element " + in_quotes(element.name) + " there are");
    element.count = *count;
    return element;
}

// Leaves text at the body.
Header read_header(std::string_view& text) {
    if (next_line(text) != "ply") refuse("line 1: the word ply is missing");
    Header header;
    bool has_format = false;
    for (;;) {
        if (text.empty()) refuse("the header has no end_header line");
        std::string_view line = next_line(text);
        const std::string_view keyword = next_word(line);
        if (keyword == "end_header") break;
        if (keyword == "format") {
            header.encoding = encoding_of(next_word(line));
            has_format = true;
        } else if (keyword == "element") {
            header.elements.push_back(read_element(line));
        } else if (keyword == "property") {
            if (header.elements.empty()) refuse("the header has a property before any element");
            header.elements.back().properties.push_back(read_property(line));
        }
    }
    if (!has_format) refuse("the header has no format line");
    return header;
}

const Element* find(const Header& header, std::string_view name) {
    for (const Element& element : header.elements) {
        if (element.name == name) return &element;
    }
    return nullptr;
}

void check_elements(const Header& header) {
    if (!find(header, "vertex")) refuse("the header has no element 'vertex'");
    if (find(header, "tristrips")) refuse("triangle strips are not read; export triangles");
}

// Names under which assimp finds x, y, z and the colour of a vertex.
constexpr std::array<std::string_view, 9> read_names{"x", "y", "z", "red", "green", "blue", "r", "g", "b"};

bool is_read(std::string_view name) {
    return std::find(read_names.begin(), read_names.end(), name) != read_names.end();
}

bool is_red(std::string_view name) { return name == "red" || name == "r"; }

// "Red", "diffuse_red", "vertex-colors", "rgb": what someone would take for a colour.
bool looks_like_red(std::string_view name) {
    std::string word;
    const auto is_color = [&] {
        for (const char* color : {"red", "rgb", "rgba", "color", "colors", "colour", "colours"}) {
            if (word == color) return true;
        }
        return false;
    };
    for (const char c : name) {
        const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        if (lower >= 'a' && lower <= 'z') {
            word += lower;
        } else if (is_color()) {
            return true;
        } else {
            word.clear();
        }
    }
    return is_color() || name == "R";
}

void check_declared_once(const Element& vertex) {
    for (std::size_t i = 0; i < vertex.properties.size(); ++i) {
        const std::string& name = vertex.properties[i].name;
        for (std::size_t k = 0; k < i; ++k) {
            const std::string& other = vertex.properties[k].name;
            if (is_read(name) && (other == name || (is_red(name) && is_red(other))))
                refuse("the header gives a vertex both " + in_quotes(other) + " and then " + in_quotes(name));
        }
    }
}

// assimp halves the range of signed integers and so loses every 0, which is a lock; and it knows few names.
void check_colours(const Element& vertex) {
    bool has_red = false;
    const Property* odd = nullptr;
    for (const Property& property : vertex.properties) {
        has_red = has_red || is_red(property.name);
        if (looks_like_red(property.name) && !is_read(property.name)) odd = &property;
        const bool is_coordinate = property.name == "x" || property.name == "y" || property.name == "z";
        if (!is_read(property.name) || is_coordinate) continue;
        if (property.list_count)
            refuse("the vertex colour " + in_quotes(property.name) + " is a list; export one number");
        if (property.type.kind == Kind::signed_integer) {
            refuse("the vertex colour " + in_quotes(property.name) +
                   " is of a signed type, whose range has no agreed meaning; export colours as uchar or float");
        }
    }
    if (has_red || !odd) return;
    refuse("the vertex property " + in_quotes(odd->name) +
           " looks like a colour, but only red, green and blue are read, and locks in it would be lost; rename it");
}

std::string place(const Element& element, std::uint64_t row) {
    return printable(element.name) + " " + std::to_string(row);
}

// Hands out the body's numbers one by one, whichever way they are written.
class Body {
public:
    // Of the whole file the header is gone already.
    Body(std::string_view file, std::string_view body, Encoding encoding)
        : file_(file), left_(body), encoding_(encoding) {}

    double next(Type type, const Element& element, std::uint64_t row) {
        if (encoding_ == Encoding::ascii) return next_in_text(type, element, row);
        if (left_.size() < type.size) {
            refuse("the file ends within " + place(element, row) + " of " + std::to_string(element.count));
        }
        std::array<char, 8> bytes{};
        std::memcpy(bytes.data(), left_.data(), type.size);
        left_.remove_prefix(type.size);
        if (encoding_ == Encoding::big)
            std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(type.size));
        return value(bytes.data(), type);
    }

    [[nodiscard]] std::size_t size_left() const { return left_.size(); }

    // Bytes from the first on that says something and that nobody asked for.
    [[nodiscard]] std::size_t unread() const {
        std::string_view rest = left_;
        return next_word(rest).size() + rest.size();
    }

private:
    double next_in_text(Type type, const Element& element, std::uint64_t row) {
        const std::string_view word = next_word(left_);
        if (word.empty())
            refuse("the file ends within " + place(element, row) + " of " + std::to_string(element.count));
        const auto value = to_number<double>(word);
        if (!value) refuse(line() + in_quotes(word) + " in " + place(element, row) + " is not a number");
        // assimp takes what it finds there, and cuts it to fit: -1 would become 0, a lock.
        if (type.kind != Kind::real && !fits(*value, type))
            refuse(line() + in_quotes(word) + " in " + place(element, row) +
                   " does not fit its type, a whole number of " + std::to_string(8 * type.size) +
                   " bits; export colours from 0 to 255, or as float");
        return *value;
    }

    // Of the word just read.
    [[nodiscard]] std::string line() const {
        const std::string_view read = file_.substr(0, file_.size() - left_.size());
        return "line " + std::to_string(std::count(read.begin(), read.end(), '\n') + 1) + ": ";
    }

    static bool fits(double value, Type type) {
        const bool is_signed = type.kind == Kind::signed_integer;
        const double end = std::ldexp(1.0, static_cast<int>(8 * type.size) - (is_signed ? 1 : 0));
        return value == std::floor(value) && value < end && value >= (is_signed ? -end : 0);
    }

    template <class T>
    static double as(const char* bytes) {
        T value;
        std::memcpy(&value, bytes, sizeof value);
        return static_cast<double>(value);
    }
    static double value(const char* bytes, Type type) {
        switch (type.kind) {
            case Kind::real:
                return type.size == 4 ? as<float>(bytes) : as<double>(bytes);
            case Kind::signed_integer:
                return type.size == 1   ? as<std::int8_t>(bytes)
                       : type.size == 2 ? as<std::int16_t>(bytes)
                                        : as<std::int32_t>(bytes);
            case Kind::unsigned_integer:
                break;
        }
        return type.size == 1   ? as<std::uint8_t>(bytes)
               : type.size == 2 ? as<std::uint16_t>(bytes)
                                : as<std::uint32_t>(bytes);
    }

    std::string_view file_;
    std::string_view left_;
    Encoding encoding_;
};

// The least an element takes, so that an absurd count is refused at once.
std::size_t least_size(const Element& element, Encoding encoding) {
    std::size_t size = 0;
    for (const Property& property : element.properties) {
        if (encoding == Encoding::ascii)
            size += 2;
        else
            size += property.list_count ? property.list_count->size : property.type.size;
    }
    return size;
}

void check_count(const Element& element, Encoding encoding, const Body& body) {
    const std::size_t least = least_size(element, encoding);
    if (element.count == 0 || (least > 0 && element.count <= body.size_left() / least + 1)) return;
    refuse("the header announces " + std::to_string(element.count) + " of element " + in_quotes(element.name) +
           ", but only " + std::to_string(body.size_left()) + " bytes follow");
}

bool is_face_list(const Element& element, const Property& property) {
    return element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void read_face(Body& body, const Element& element, const Property& property, std::uint64_t row,
               std::uint64_t vertex_count, Prescan& result) {
    const double corners = body.next(*property.list_count, element, row);
    for (double i = 0; i < corners; ++i) {
        const double vertex = body.next(property.type, element, row);
        if (!(vertex >= 0) || vertex >= static_cast<double>(vertex_count)) {
            refuse(place(element, row) + " refers to a vertex that is not there; the file is damaged");
        }
    }
    if (corners >= 3) result.expected_triangles += static_cast<std::uint64_t>(corners) - 2;
}

void read_list(Body& body, const Element& element, const Property& property, std::uint64_t row) {
    const double size = body.next(*property.list_count, element, row);
    for (double i = 0; i < size; ++i) (void)body.next(property.type, element, row);
}

// As assimp scales it: whole numbers by the largest of their type.
float red_of(double value, Type type) {
    const double most = std::ldexp(1.0, static_cast<int>(8 * type.size)) - 1;
    return static_cast<float>(type.kind == Kind::real ? value : value / most);
}

int axis_of(const Element& element, const Property& property) {
    if (element.name != "vertex" || property.list_count) return -1;
    return property.name == "x" ? 0 : property.name == "y" ? 1 : property.name == "z" ? 2 : -1;
}

void read_row(Body& body, const Element& element, std::uint64_t row, std::uint64_t vertex_count, Prescan& result) {
    Vec3f position;
    for (const Property& property : element.properties) {
        if (is_face_list(element, property) && property.list_count) {
            read_face(body, element, property, row, vertex_count, result);
        } else if (property.list_count) {
            read_list(body, element, property, row);
        } else {
            const double value = body.next(property.type, element, row);
            if (element.name == "vertex" && is_red(property.name)) result.reds.push_back(red_of(value, property.type));
            const int axis = axis_of(element, property);
            if (axis < 0) continue;
            if (const auto fault = coordinate_fault(value); !fault.empty())
                refuse("coordinate " + property.name + " of " + place(element, row) + " " + std::string(fault));
            position[axis] = static_cast<float>(value);
        }
    }
    if (element.name == "vertex") result.positions.push_back(position);
}

}

Prescan prescan_ply(std::string_view bytes, Purpose purpose) {
    std::string_view left = bytes;
    const Header header = read_header(left);
    check_elements(header);
    const Element& vertex = *find(header, "vertex");
    check_declared_once(vertex);
    if (purpose == Purpose::shell) check_colours(vertex);
    Prescan result;
    Body body(bytes, left, header.encoding);
    for (const Element& element : header.elements) {
        check_count(element, header.encoding, body);
        for (std::uint64_t row = 0; row < element.count; ++row) read_row(body, element, row, vertex.count, result);
    }
    result.unread.bytes = body.unread();
    if (purpose != Purpose::shell) result.reds.clear();
    return result;
}

}
