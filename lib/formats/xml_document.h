// SPDX-License-Identifier: GPL-3.0-or-later
// The elements of an XML file, for a look at it before assimp reads it; by pugixml, as assimp does. Views into the
// file's text; entities stand as they are written.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/index.h"

namespace crumple::formats::xml {

struct Attribute {
    std::string_view name;
    std::string_view value;
};

struct Element {
    std::string_view name;
    std::string_view text;  // the first of its own text that is not blank: what assimp takes for all of it
    std::size_t line = 0;   // where it begins
    Index first_child = none;
    Index next_sibling = none;
    std::vector<Attribute> attributes;
};

using Document = std::vector<Element>;  // in the file's order; the first is the root

// Throws Error(bad_input) that names the line, for what is not well formed, has no element or is nested beyond measure.
[[nodiscard]] Document parse(std::string_view text);

// Nothing where it is absent.
[[nodiscard]] std::optional<std::string_view> attribute(const Element& element, std::string_view name);

// "line 7: ", and "<source> 'g-c'": how a message names an element.
[[nodiscard]] std::string line(const Element& element);
[[nodiscard]] std::string tag(const Element& element);

// Calls visit(index) for the children of that name, in order.
template <class Visit>
void for_each_child(const Document& document, Index parent, std::string_view name, Visit&& visit) {
    for (Index child = document[parent].first_child; child != none; child = document[child].next_sibling) {
        if (document[child].name == name) visit(child);
    }
}

// The first child of that name, or none.
[[nodiscard]] Index find_child(const Document& document, Index parent, std::string_view name);

}
