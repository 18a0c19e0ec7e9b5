// SPDX-License-Identifier: GPL-3.0-or-later
// The nodes of an FBX file as its text or bytes are read from the beginning.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "formats/fbx_document.h"

namespace crumple::formats::fbx {

// Throws Error(bad_input). place: line of text, byte of a binary file.
[[noreturn]] void refuse_at(bool is_binary, std::size_t place, const std::string& what);

// Puts nodes under those that are open.
class Tree {
public:
    explicit Tree(bool is_binary) : is_binary_(is_binary), nodes_(1), last_child_(1, none), open_{0} {}

    void add(const Node& node);
    void open();  // the node added last takes those that follow
    void close() { open_.pop_back(); }
    [[nodiscard]] bool is_open() const { return open_.size() > 1; }
    [[nodiscard]] const Node& innermost() const { return nodes_[open_.back()]; }
    [[nodiscard]] Document take() { return {std::move(nodes_), is_binary_}; }

private:
    bool is_binary_;
    std::vector<Node> nodes_;
    std::vector<Index> last_child_;
    std::vector<Index> open_;
};

// Throw Error(bad_input) where a node does not end, or lies outside of what holds it.
[[nodiscard]] Document parse_text(std::string_view text);
[[nodiscard]] Document parse_binary(std::string_view bytes);

// What a binary file begins with; two bytes and the version follow.
inline constexpr std::string_view binary_mark("Kaydara FBX Binary  \0", 21);

}
