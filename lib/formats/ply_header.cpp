// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/ply_header.h"

#include <algorithm>

#include "core/error.h"
#include "formats/printable.h"
#include "formats/text.h"

namespace crumple::formats::ply {

namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::bad_input, what); }

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

struct MeaningName {
    std::string_view name;
    Meaning meaning;
};

constexpr MeaningName meaning_names[] = {
    {"x", Meaning::x},       {"y", Meaning::y},     {"z", Meaning::z},         {"red", Meaning::red},
    {"r", Meaning::red},     {"g", Meaning::green}, {"b", Meaning::blue},      {"green", Meaning::green},
    {"blue", Meaning::blue}, {"a", Meaning::alpha}, {"alpha", Meaning::alpha},
};

Type type_of(std::string_view name) {
    for (const TypeName& entry : type_names) {
        if (entry.name == name) return entry.type;
    }
    refuse("the header names an unknown type " + in_quotes(name));
}

Meaning meaning_of(std::string_view name) {
    for (const MeaningName& entry : meaning_names) {
        if (entry.name == name) return entry.meaning;
    }
    return Meaning::other;
}

Encoding encoding_of(std::string_view name) {
    if (name == "ascii") return Encoding::ascii;
    if (name == "binary_little_endian") return Encoding::little;
    if (name == "binary_big_endian") return Encoding::big;
    refuse("the header names an unknown format " + in_quotes(name));
}

Property read_property(std::string_view line, std::size_t number) {
    Property property;
    std::string_view word = next_word(line);
    if (word == "list") {
        property.list_count = type_of(next_word(line));
        if (property.list_count->kind == Kind::real) refuse("the header counts a list with a real number");
        word = next_word(line);
    }
    property.type = type_of(word);
    property.name = std::string(next_word(line));
    property.meaning = meaning_of(property.name);
    property.line = number;
    return property;
}

Element read_element(std::string_view line, const Header& header) {
    Element element;
    element.name = std::string(next_word(line));
    if (find(header, element.name)) refuse("the header announces element " + in_quotes(element.name) + " twice");
    const auto count = to_number<std::uint64_t>(next_word(line));
    if (!count) refuse("the header does not say how many of element " + in_quotes(element.name) + " there are");
    element.count = *count;
    return element;
}

}

Header read_header(std::string_view& text) {
    std::string_view first = next_line(text);
    if (next_word(first) != "ply") refuse("line 1: the word ply is missing");
    // Lines that end in carriage returns alone are all one.
    if (first.find('\r') != std::string_view::npos && !next_word(first).empty())
        refuse("the header is one line; its lines must end in line feeds");
    Header header;
    bool has_format = false;
    for (std::size_t number = 2;; ++number) {
        if (text.empty()) refuse("the header has no end_header line");
        std::string_view line = next_line(text);
        const std::string_view keyword = next_word(line);
        if (keyword == "end_header") break;
        if (keyword == "format") {
            header.encoding = encoding_of(next_word(line));
            has_format = true;
        } else if (keyword == "element") {
            header.elements.push_back(read_element(line, header));
        } else if (keyword == "property") {
            if (header.elements.empty()) refuse("the header has a property before any element");
            header.elements.back().properties.push_back(read_property(line, number));
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

}
