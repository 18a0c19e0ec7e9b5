// SPDX-License-Identifier: GPL-3.0-or-later
#include "bake/node_order.h"

#include <gtest/gtest.h>

#include "bake/grid_input.h"

using namespace crumple;
using bake::NodeOrder;

namespace {

// Nodes of a chain of `count` at x = 0, 1, 2, ..., numbered in a random order.
struct Chain {
    std::vector<Vec3> positions;
    std::vector<Edge> edges;
};

Chain shuffled_chain(Index count, std::uint64_t seed) {
    Rng rng(seed);
    std::vector<Index> number(count);
    std::iota(number.begin(), number.end(), 0u);
    for (Index i = count; i > 1; --i) std::swap(number[i - 1], number[rng.next_below(i)]);
    Chain chain{std::vector<Vec3>(count), {}};
    for (Index k = 0; k < count; ++k) chain.positions[number[k]] = {double(k), 0, 0};
    for (Index k = 0; k + 1 < count; ++k) chain.edges.push_back({number[k], number[k + 1]});
    return chain;
}

Index bandwidth(const std::vector<Index>& order, const std::vector<Edge>& edges) {
    std::vector<Index> place(order.size());
    for (Index k = 0; k < order.size(); ++k) place[order[k]] = k;
    Index widest = 0;
    for (const auto& [i, j] : edges)
        widest = std::max(widest, std::max(place[i], place[j]) - std::min(place[i], place[j]));
    return widest;
}

}

TEST(NodeOrder, OfNothingIsNothing) {
    for (const NodeOrder how : {NodeOrder::rcm, NodeOrder::axis, NodeOrder::mesh})
        EXPECT_TRUE(bake::order_nodes({}, {}, how).empty());
}

TEST(NodeOrder, NodesWithoutEdgesComeLastByPosition) {
    const std::vector<Vec3> positions = {{5, 0, 0}, {0, 0, 0}, {3, 0, 0}, {9, 0, 0}};
    const std::vector<Edge> edges = {{2, 3}};
    for (const NodeOrder how : {NodeOrder::rcm, NodeOrder::axis, NodeOrder::mesh}) {
        const auto order = bake::order_nodes(positions, edges, how);
        EXPECT_EQ(std::vector<Index>(order.begin() + 2, order.end()), (std::vector<Index>{1, 0}));
    }
}

TEST(NodeOrder, AChainGetsBandwidthOne) {
    const Chain chain = shuffled_chain(1000, 3);
    EXPECT_GT(bandwidth(bake::order_nodes(chain.positions, chain.edges, NodeOrder::mesh), chain.edges), 500u);
    EXPECT_EQ(bandwidth(bake::order_nodes(chain.positions, chain.edges, NodeOrder::rcm), chain.edges), 1u);
    EXPECT_EQ(bandwidth(bake::order_nodes(chain.positions, chain.edges, NodeOrder::axis), chain.edges), 1u);
}

TEST(NodeOrder, TwoIslandsStayApart) {
    Chain chain = shuffled_chain(50, 1);
    const Chain other = shuffled_chain(30, 2);
    for (const Vec3 p : other.positions) chain.positions.push_back(p + Vec3{0.5, 1, 0});
    for (const auto& [i, j] : other.edges) chain.edges.push_back({i + 50, j + 50});
    EXPECT_EQ(bandwidth(bake::order_nodes(chain.positions, chain.edges, NodeOrder::rcm), chain.edges), 1u);
}

TEST(NodeOrder, BakeNarrowsAShuffledCube) {
    const auto result = test::bake_input(test::shuffled(test::grid_input(8), 11));
    // A cube of n^3 nodes cannot do better than about n^2 = 81 with a straight sweep; random numbers give about all
    // 729.
    EXPECT_GT(result.report.bandwidth_before, 600u);
    EXPECT_LT(result.report.bundle.bandwidth, 250u);
}
