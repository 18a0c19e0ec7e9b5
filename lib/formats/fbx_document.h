// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of an FBX file of version 7, text or binary, for a look at it before assimp reads it. Views into the file's
// bytes; values are read when they are asked for.
//
// Text is "Name: value, value { nodes }", an array "Name: *count { a: values }". Binary is, for each node: offset of
// its end, number of values, bytes of values, name, values, nodes and an empty node; the first three are of 32 bits
// below version 7500 and of 64 from there [Blender, "FBX binary file format specification", 2013].
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/index.h"

namespace crumple::formats::fbx {

struct Node {
    std::string_view name;
    std::string_view values;  // as they stand in the file
    std::size_t place = 0;    // line of text, byte of a binary file
    Index first_child = none;
    Index next_sibling = none;
};

struct Document {
    std::vector<Node> nodes;  // the first is no node of the file, but holds them
    bool is_binary = false;
};

// Throws Error(bad_input) that names the place where a node does not end, or lies outside the file.
[[nodiscard]] Document parse(std::string_view bytes);

// The value of that position as text or as a number; nothing where it is none.
[[nodiscard]] std::optional<std::string> text_of(const Document& document, const Node& node, std::size_t position);
[[nodiscard]] std::optional<double> number_of(const Document& document, const Node& node, std::size_t position);

// How many numbers an array holds, and which. Throws Error(bad_input) where it is damaged, or announces another count.
[[nodiscard]] std::uint64_t array_size(const Document& document, const Node& node);
[[nodiscard]] std::vector<double> array_of(const Document& document, const Node& node);

// The first child of that name, or none.
[[nodiscard]] Index find_child(const Document& document, Index parent, std::string_view name);

// Calls visit(index) for the children of that name, in order.
template <class Visit>
void for_each_child(const Document& document, Index parent, std::string_view name, Visit&& visit) {
    for (Index child = document.nodes[parent].first_child; child != none; child = document.nodes[child].next_sibling) {
        if (document.nodes[child].name == name) visit(child);
    }
}

// "line 7: Colors " or "byte 700: Colors " before what is wrong.
[[noreturn]] void refuse(const Document& document, const Node& node, const std::string& what);

}
