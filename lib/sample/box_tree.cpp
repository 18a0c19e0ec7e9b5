// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/box_tree.h"

#include <algorithm>
#include <numeric>

namespace crumple::sample {

namespace {

constexpr Index leaf_size = 4;

void build(BoxTree& tree, std::span<const Box> boxes, Index first, Index count) {
    const auto index = static_cast<Index>(tree.nodes.size());
    BoxTree::Node node;
    node.first = first;
    node.count = count;
    Box centres;
    for (Index i = first; i < first + count; ++i) {
        const Box& box = boxes[tree.items[i]];
        node.box.add(box.low);
        node.box.add(box.high);
        centres.add(box.low + box.high);
    }
    tree.nodes.push_back(node);
    if (count <= leaf_size) return;
    const Vec3 size = centres.high - centres.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto begin = tree.items.begin() + first;
    const Index half = count / 2;
    std::nth_element(begin, begin + half, begin + count, [&](Index a, Index b) {
        const double at_a = boxes[a].low[axis] + boxes[a].high[axis];
        const double at_b = boxes[b].low[axis] + boxes[b].high[axis];
        return at_a != at_b ? at_a < at_b : a < b;
    });
    build(tree, boxes, first, half);
    tree.nodes[index].right = static_cast<Index>(tree.nodes.size());
    build(tree, boxes, first + half, count - half);
}

}

BoxTree build_box_tree(std::span<const Box> boxes) {
    BoxTree tree;
    tree.items.resize(boxes.size());
    std::iota(tree.items.begin(), tree.items.end(), Index{0});
    if (!boxes.empty()) build(tree, boxes, 0, static_cast<Index>(boxes.size()));
    return tree;
}

}
