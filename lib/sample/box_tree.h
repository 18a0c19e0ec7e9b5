// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the item of least cost, where a box bounds the cost of what lies in it from below: nearest triangle, nearest
// vertex, smallest element size.
#pragma once
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "core/index.h"
#include "geometry/measures.h"

namespace crumple::sample {

struct BoxTree {
    struct Node {
        Box box;
        Index first = 0;  // of items
        Index count = 0;
        Index right = none;  // the left child is the next node; none at a leaf
    };
    std::vector<Node> nodes;   // the root is the first; children come after their parent
    std::vector<Index> items;  // a node's items are items[first, first + count)
};

// One box an item.
[[nodiscard]] BoxTree build_box_tree(std::span<const Box> boxes);

[[nodiscard]] inline double distance_2(const Box& box, Vec3 p) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double outside = std::fmax(0, std::fmax(box.low[axis] - p[axis], p[axis] - box.high[axis]));
        sum += outside * outside;
    }
    return sum;
}

// The least cost(item), or `best` when none is below it. bound(node index) must not exceed the cost of any item in the
// node.
template <class Bound, class Cost>
double least_cost(const BoxTree& tree, const Bound& bound, const Cost& cost, double best) {
    if (tree.nodes.empty()) return best;
    struct Waiting {
        Index node;
        double bound;
    };
    std::array<Waiting, 64> stack;  // halving 2^32 items never goes deeper than 33
    std::size_t waiting = 0;
    stack[waiting++] = {0, bound(Index{0})};
    while (waiting > 0) {
        const Waiting next = stack[--waiting];
        if (next.bound >= best) continue;
        const BoxTree::Node& node = tree.nodes[next.node];
        if (node.right == none) {
            for (Index i = node.first; i < node.first + node.count; ++i) best = std::fmin(best, cost(tree.items[i]));
            continue;
        }
        const Waiting left{next.node + 1, bound(next.node + 1)};
        const Waiting right{node.right, bound(node.right)};
        const bool left_first = left.bound <= right.bound;
        stack[waiting++] = left_first ? right : left;
        stack[waiting++] = left_first ? left : right;
    }
    return best;
}

}
