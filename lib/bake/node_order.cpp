// SPDX-License-Identifier: GPL-3.0-or-later
// Reverse Cuthill-McKee [Cuthill and McKee 1969; George 1971] from a pseudo-peripheral node [George and Liu 1979].
#include "bake/node_order.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace crumple::bake {
namespace {

struct Graph {
    std::vector<Index> start;      // n + 1
    std::vector<Index> neighbour;  // of node i: [start[i], start[i + 1]), by rising (degree, place)
    std::vector<Index> place;      // of a node in the lexicographic order of positions: breaks every tie

    [[nodiscard]] Index degree(Index node) const { return start[node + 1] - start[node]; }
    [[nodiscard]] std::span<const Index> neighbours(Index node) const {
        return {neighbour.data() + start[node], neighbour.data() + start[node + 1]};
    }
    [[nodiscard]] bool before(Index a, Index b) const {
        return std::pair(degree(a), place[a]) < std::pair(degree(b), place[b]);
    }
};

// Longest axis of the box first, so that `axis` is this order and rcm takes its ties from it.
std::vector<Index> sort_along_axis(std::span<const Vec3> positions) {
    Vec3 low = positions.empty() ? Vec3{} : positions[0];
    Vec3 high = low;
    for (const Vec3 p : positions) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    const Vec3 size = high - low;
    const int longest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::vector<Index> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        const double x = positions[a][longest];
        const double y = positions[b][longest];
        if (x != y) return x < y;
        if (positions[a] != positions[b]) return lexicographic_less(positions[a], positions[b]);
        return a < b;
    });
    return order;
}

Graph build_graph(std::span<const Edge> edges, const std::vector<Index>& axis_order) {
    const std::size_t count = axis_order.size();
    Graph graph{std::vector<Index>(count + 1, 0), std::vector<Index>(2 * edges.size()), std::vector<Index>(count)};
    for (Index k = 0; k < count; ++k) graph.place[axis_order[k]] = k;
    for (const auto& [i, j] : edges) {
        ++graph.start[i + 1];
        ++graph.start[j + 1];
    }
    std::partial_sum(graph.start.begin(), graph.start.end(), graph.start.begin());
    std::vector<Index> next(graph.start.begin(), graph.start.end() - 1);
    for (const auto& [i, j] : edges) {
        graph.neighbour[next[i]++] = j;
        graph.neighbour[next[j]++] = i;
    }
    for (Index node = 0; node < count; ++node) {
        std::sort(graph.neighbour.begin() + graph.start[node], graph.neighbour.begin() + graph.start[node + 1],
                  [&](Index a, Index b) { return graph.before(a, b); });
    }
    return graph;
}

// Breadth-first searches that forget what they visited by raising a stamp instead of clearing.
class Search {
public:
    explicit Search(const Graph& graph) : graph_(graph), seen_(graph.place.size(), 0) {}

    // Appends the component of root to order, in Cuthill-McKee order; returns the number of levels and where the last
    // one begins.
    std::pair<Index, std::size_t> run(Index root, std::vector<Index>& order) {
        ++stamp_;
        seen_[root] = stamp_;
        std::size_t level_begin = order.size();
        order.push_back(root);
        for (Index levels = 1;; ++levels) {
            const std::size_t level_end = order.size();
            for (std::size_t k = level_begin; k < level_end; ++k) {
                for (const Index node : graph_.neighbours(order[k])) {
                    if (seen_[node] == stamp_) continue;
                    seen_[node] = stamp_;
                    order.push_back(node);
                }
            }
            if (order.size() == level_end) return {levels, level_begin};
            level_begin = level_end;
        }
    }

private:
    const Graph& graph_;
    std::vector<std::uint32_t> seen_;
    std::uint32_t stamp_ = 0;
};

// A node far from the others: jumps to the far end until the far end is no farther.
Index find_peripheral_node(const Graph& graph, Search& search, Index root) {
    std::vector<Index> order;
    auto [levels, last] = search.run(root, order);
    for (;;) {
        const Index candidate = *std::min_element(order.begin() + static_cast<std::ptrdiff_t>(last), order.end(),
                                                  [&](Index a, Index b) { return graph.before(a, b); });
        order.clear();
        const auto [candidate_levels, candidate_last] = search.run(candidate, order);
        if (candidate_levels <= levels) return root;
        root = candidate;
        levels = candidate_levels;
        last = candidate_last;
    }
}

std::vector<Index> reverse_cuthill_mckee(const Graph& graph, const std::vector<Index>& axis_order) {
    Search search(graph);
    std::vector<Index> order;
    order.reserve(axis_order.size());
    std::vector<std::uint8_t> is_ordered(axis_order.size(), 0);
    for (const Index root : axis_order) {
        if (is_ordered[root] || graph.degree(root) == 0) continue;
        const std::size_t begin = order.size();
        search.run(find_peripheral_node(graph, search, root), order);
        for (std::size_t k = begin; k < order.size(); ++k) is_ordered[order[k]] = 1;
    }
    std::reverse(order.begin(), order.end());
    return order;
}

}

std::vector<Index> order_nodes(std::span<const Vec3> positions, std::span<const Edge> edges, NodeOrder how) {
    std::vector<Index> axis_order = sort_along_axis(positions);
    const Graph graph = build_graph(edges, axis_order);
    std::vector<Index> order = how == NodeOrder::rcm ? reverse_cuthill_mckee(graph, axis_order) : axis_order;
    if (how == NodeOrder::mesh) std::iota(order.begin(), order.end(), 0u);
    if (how != NodeOrder::rcm) std::erase_if(order, [&](Index node) { return graph.degree(node) == 0; });
    for (const Index node : axis_order) {
        if (graph.degree(node) == 0) order.push_back(node);
    }
    return order;
}

}
