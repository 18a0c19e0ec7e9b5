// SPDX-License-Identifier: GPL-3.0-or-later
// What a PLY file announces: its encoding, and the properties of each element.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crumple::formats::ply {

enum class Encoding { ascii, little, big };
enum class Kind { signed_integer, unsigned_integer, real };

struct Type {
    Kind kind;
    std::size_t size;  // bytes, where it is not text
};

// What a property of a vertex is to us.
enum class Meaning { other, x, y, z, red, green, blue, alpha };

struct Property {
    std::string name;
    Meaning meaning = Meaning::other;
    Type type{};                     // of the value, or of the list's values
    std::optional<Type> list_count;  // of a list's length
    std::size_t line = 0;            // of the file
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

// Leaves text at the body. Throws Error(bad_input).
[[nodiscard]] Header read_header(std::string_view& text);

// Null where there is none.
[[nodiscard]] const Element* find(const Header& header, std::string_view name);

}
