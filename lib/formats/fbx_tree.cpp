// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/fbx_tree.h"

#include "core/error.h"

namespace crumple::formats::fbx {

namespace {

// Files have a handful of levels; assimp calls itself for each.
constexpr std::size_t deepest = 500;

}

void refuse_at(bool is_binary, std::size_t place, const std::string& what) {
    throw Error(ErrorKind::bad_input, (is_binary ? "byte " : "line ") + std::to_string(place) + ": " + what +
                                          "; the file is damaged or cut short: export it again");
}

void Tree::add(const Node& node) {
    const auto index = static_cast<Index>(nodes_.size());
    Index& last = last_child_[open_.back()];
    (last == none ? nodes_[open_.back()].first_child : nodes_[last].next_sibling) = index;
    last = index;
    nodes_.push_back(node);
    last_child_.push_back(none);
}

void Tree::open() {
    open_.push_back(static_cast<Index>(nodes_.size() - 1));
    if (open_.size() > deepest)
        refuse_at(is_binary_, nodes_.back().place, "nodes are nested more than " + std::to_string(deepest) + " deep");
}

}
