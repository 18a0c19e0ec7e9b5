// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.h"
#include "formats/color_name.h"
#include "formats/coordinate.h"
#include "formats/ply_body.h"
#include "formats/ply_header.h"
#include "formats/ply_surface.h"
#include "formats/prescan.h"
#include "formats/printable.h"

namespace crumple::formats {

namespace {

using ply::Body;
using ply::Element;
using ply::Encoding;
using ply::Header;
using ply::Kind;
using ply::Meaning;
using ply::Property;
using ply::Type;

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::bad_input, what); }

[[noreturn]] void refuse(const Property& property, const std::string& what) {
    refuse("line " + std::to_string(property.line) + ": " + what);
}

bool is_coordinate(Meaning meaning) { return meaning == Meaning::x || meaning == Meaning::y || meaning == Meaning::z; }

// Alpha says nothing of a lock.
bool is_color(Meaning meaning) {
    return meaning == Meaning::red || meaning == Meaning::green || meaning == Meaning::blue;
}

bool is_face_list(const Property& property) {
    return property.list_count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void check_declared_once(const Element& vertex, bool (*is_read)(Meaning)) {
    for (std::size_t i = 0; i < vertex.properties.size(); ++i) {
        const Property& property = vertex.properties[i];
        if (!is_read(property.meaning)) continue;
        for (std::size_t k = 0; k < i; ++k) {
            if (vertex.properties[k].meaning == property.meaning)
                refuse(property, "the header gives a vertex both " + in_quotes(vertex.properties[k].name) +
                                     " and then " + in_quotes(property.name));
        }
    }
}

void check_coordinates(const Element& vertex) {
    check_declared_once(vertex, is_coordinate);
    int count = 0;
    for (const Property& property : vertex.properties) {
        if (!is_coordinate(property.meaning)) continue;
        if (property.list_count) refuse(property, "the coordinate " + in_quotes(property.name) + " is a list");
        ++count;
    }
    if (count < 3) refuse("the header does not give a vertex x, y and z");
}

// Whole numbers of 8 and 16 bits mean shares of their largest; of others nobody knows what the largest is.
void check_color_type(const Property& property) {
    if (property.list_count)
        refuse(property, "the vertex colour " + in_quotes(property.name) + " is a list; export one number");
    if (property.type.kind == Kind::real || (property.type.kind == Kind::unsigned_integer && property.type.size <= 2))
        return;
    refuse(property, "the vertex colour " + in_quotes(property.name) + " is of a " +
                         (property.type.kind == Kind::signed_integer ? "signed" : "32-bit") +
                         " type, whose range has no agreed meaning; export colours as uchar or float");
}

// A colour without red would have a red of 0: a lock.
void check_has_red(const Element& vertex) {
    const Property* color = nullptr;
    for (const Property& property : vertex.properties) {
        if (property.meaning == Meaning::red) return;
        if (is_color(property.meaning)) color = &property;
    }
    if (color)
        refuse(*color, "the header gives a vertex " + in_quotes(color->name) +
                           " but no red, which says what is locked; export red, green and blue, or rename it");
}

void check_colors(const Element& vertex) {
    check_declared_once(vertex, is_color);
    bool has_red = false;
    const Property* odd = nullptr;
    for (const Property& property : vertex.properties) {
        has_red = has_red || property.meaning == Meaning::red;
        if (is_color(property.meaning)) check_color_type(property);
        if (property.meaning == Meaning::other && looks_like_color(property.name)) odd = &property;
    }
    if (!has_red && odd)
        refuse(*odd, "the vertex property " + in_quotes(odd->name) +
                         " looks like a colour, but only red, green and blue are read, and locks in it would be lost; "
                         "rename it");
    check_has_red(vertex);
}

void check_faces(const Element* face) {
    if (!face || face->count == 0) return;
    const auto lists = std::count_if(face->properties.begin(), face->properties.end(), is_face_list);
    if (lists == 0) refuse("the header gives a face no list 'vertex_indices'");
    if (lists > 1) refuse("the header gives a face more than one list of its vertices");
}

void check_elements(const Header& header, Purpose purpose) {
    const Element* vertex = ply::find(header, "vertex");
    if (!vertex) refuse("the header has no element 'vertex'");
    if (ply::find(header, "tristrips")) refuse("triangle strips are not read; export triangles");
    check_coordinates(*vertex);
    if (purpose == Purpose::shell) check_colors(*vertex);
    check_faces(ply::find(header, "face"));
}

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

float share_of(double value, Type type) {
    const float most = static_cast<float>(std::ldexp(1.0, static_cast<int>(8 * type.size)) - 1);
    return type.kind == Kind::real ? static_cast<float>(value) : static_cast<float>(value) / most;
}

bool has_vertex_colors(const Header& header) {
    for (const Property& property : ply::find(header, "vertex")->properties) {
        if (is_color(property.meaning)) return true;
    }
    return false;
}

std::uint64_t count_colored_faces(const Header& header) {
    const Element* face = ply::find(header, "face");
    if (!face) return 0;
    for (const Property& property : face->properties) {
        const bool is_red = property.meaning == Meaning::red;
        if (!property.list_count && (is_red || looks_like_color(property.name))) return face->count;
    }
    return 0;
}

// Reads the elements one by one and keeps what is a surface.
class Reader {
public:
    Reader(const Header& header, Body body, bool reads_colors, Prescan& result)
        : header_(header),
          vertex_count_(ply::find(header, "vertex")->count),
          body_(body),
          has_colors_(reads_colors && has_vertex_colors(header)),
          surface_(has_colors_),
          result_(result) {}

    void read() {
        for (const Element& element : header_.elements) {
            check_count(element, header_.encoding, body_);
            for (std::uint64_t row = 0; row < element.count; ++row) read_row(element, row);
        }
        result_.unread.bytes = body_.unread();
        result_.surface_only = surface_.take();
    }

private:
    void read_row(const Element& element, std::uint64_t row) {
        if (element.name == "vertex") return read_vertex(element, row);
        for (const Property& property : element.properties) {
            if (element.name == "face" && is_face_list(property))
                read_face(element, property, row);
            else
                skip(element, property, row);
        }
    }

    void read_vertex(const Element& element, std::uint64_t row) {
        Vec3f position;
        Color color{0, 0, 0, 1};
        for (const Property& property : element.properties) {
            const Meaning meaning = property.meaning;
            if (is_coordinate(meaning)) {
                position[static_cast<int>(meaning) - static_cast<int>(Meaning::x)] = coordinate(element, property, row);
            } else if (has_colors_ && meaning != Meaning::other && !property.list_count) {
                color[static_cast<std::size_t>(meaning) - static_cast<std::size_t>(Meaning::red)] =
                    share_of(body_.next(property.type, element, row), property.type);
            } else {
                skip(element, property, row);
            }
        }
        result_.positions.push_back(position);
        if (has_colors_) result_.reds.push_back(color[0]);
        surface_.add_vertex(position, color);
    }

    float coordinate(const Element& element, const Property& property, std::uint64_t row) {
        const double value = body_.next(property.type, element, row);
        const auto fault = coordinate_fault(value);
        if (!fault.empty())
            refuse("coordinate " + property.name + " of " + ply::place(element, row) + " " + std::string(fault));
        return static_cast<float>(value);
    }

    void read_face(const Element& element, const Property& property, std::uint64_t row) {
        const auto count = list_size(element, property, row);
        corners_.clear();
        for (std::uint32_t i = 0; i < count; ++i) {
            const double vertex = body_.next(property.type, element, row);
            if (!(vertex >= 0) || vertex >= static_cast<double>(vertex_count_) || vertex != std::floor(vertex))
                refuse(ply::place(element, row) + " refers to a vertex that is not there; the file is damaged");
            corners_.push_back(static_cast<std::uint32_t>(vertex));
        }
        if (corners_.size() >= 3) result_.expected_triangles += corners_.size() - 2;
        if (!corners_.empty()) surface_.add_face(corners_);  // assimp crashes on none
    }

    void skip(const Element& element, const Property& property, std::uint64_t row) {
        if (!property.list_count) return body_.skip(property.type, element, row);
        const auto size = list_size(element, property, row);
        for (std::uint32_t i = 0; i < size; ++i) body_.skip(property.type, element, row);
    }

    // Of 32 bits at most, as types go.
    std::uint32_t list_size(const Element& element, const Property& property, std::uint64_t row) {
        const double size = body_.next(*property.list_count, element, row);
        if (size < 0)
            refuse(ply::place(element, row) + " has a list " + in_quotes(property.name) +
                   " of less than no numbers; the file is damaged");
        return static_cast<std::uint32_t>(size);
    }

    const Header& header_;
    std::uint64_t vertex_count_;
    Body body_;
    bool has_colors_;
    ply::SurfaceWriter surface_;
    Prescan& result_;
    std::vector<std::uint32_t> corners_;
};

}

Prescan prescan_ply(std::string_view bytes, Purpose purpose) {
    std::string_view left = bytes;
    const Header header = ply::read_header(left);
    check_elements(header, purpose);
    Prescan result;
    result.unread.colored_faces = count_colored_faces(header);
    Reader(header, Body(bytes, left, header.encoding), purpose == Purpose::shell, result).read();
    return result;
}

}
