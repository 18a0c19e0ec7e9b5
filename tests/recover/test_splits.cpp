// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/splits.h"

#include <gtest/gtest.h>

#include "all_holders.h"
#include "exact_volume.h"
#include "mesh/shapes.h"
#include "mesh/validate.h"
#include "recover/insert_node.h"

using namespace crumple;
using namespace crumple::recover;

namespace {

// An inner edge of the grid with two facets at it, and an inner facet.
struct Task {
    TetComplex complex{shapes::tet_grid(3)};
    Constraints constraints;
    Edge edge{};
};

Index inner_edge_tet(const TetComplex& complex, TetRing& ring, Edge& edge) {
    for (Index t = 0; t < complex.slot_count(); ++t) {
        const Tet& tet = complex.corners(t);
        for (const auto& [i, j] : tet_edge_corners) {
            complex.ring_of(t, tet[i], tet[j], ring);
            if (!ring.is_closed || ring.tets.size() < 5) continue;
            edge = {tet[i], tet[j]};
            return t;
        }
    }
    return none;
}

TEST(Splits, ASplitSegmentIsMadeWholeAgain) {
    Task task;
    TetRing ring;
    ASSERT_NE(inner_edge_tet(task.complex, ring, task.edge), none);
    const auto [a, b] = task.edge;
    const Triangle f = sorted_triangle(a, b, ring.link[0]);
    const Triangle g = sorted_triangle(a, b, ring.link[2]);
    task.constraints.add_facet(f, 3);
    task.constraints.add_facet(g, 4);
    const std::string volume = exact_six_volumes(task.complex.to_mesh());
    // On the segment to float precision only, as splits are.
    const Vec3 place = round_to_float(task.complex.position(a) * 0.7 + task.complex.position(b) * 0.3);
    Constraints whole = task.constraints;
    task.constraints = {};
    const Index node = insert_node(task.complex, task.constraints, place, all_holders(task.complex, place));
    ASSERT_NE(node, none);
    task.constraints = whole;
    const Split split = split_segment(task.constraints, a, b, node);
    for (const Triangle& part : task.constraints.facets())
        ASSERT_NE(task.complex.find_face(part[0], part[1], part[2]), none);

    ASSERT_TRUE(undo_split(task.complex, task.constraints, split));
    EXPECT_EQ(task.complex.tet_at(node), none);
    EXPECT_NE(task.complex.find_edge(a, b), none);
    EXPECT_NE(task.complex.find_face(f[0], f[1], f[2]), none);
    EXPECT_NE(task.complex.find_face(g[0], g[1], g[2]), none);
    EXPECT_EQ(task.constraints.facets(), whole.facets());
    EXPECT_EQ(task.constraints.origin(g), 4u);
    EXPECT_TRUE(validate(task.complex.to_mesh()).empty());
    EXPECT_EQ(exact_six_volumes(task.complex.to_mesh()), volume);
}

TEST(Splits, ASplitFacetIsMadeWholeAgain) {
    Task task;
    TetRing ring;
    ASSERT_NE(inner_edge_tet(task.complex, ring, task.edge), none);
    const Triangle f = sorted_triangle(task.edge[0], task.edge[1], ring.link[0]);
    const Vec3 place =
        round_to_float((task.complex.position(f[0]) + task.complex.position(f[1]) + task.complex.position(f[2])) / 3);
    const std::string volume = exact_six_volumes(task.complex.to_mesh());
    // The facet's edges are segments, as they are when a facet is split.
    Constraints guard;
    for (int i = 0; i < 3; ++i) guard.add_facet({f[i], f[(i + 1) % 3], 1000}, 0);
    const Index node = insert_node(task.complex, guard, place, all_holders(task.complex, place));
    ASSERT_NE(node, none);
    task.constraints.add_facet(f, 3);
    const Split split = split_facet(task.constraints, f, node);
    bool all_there = true;
    for (const Triangle& part : task.constraints.facets())
        all_there = all_there && task.complex.find_face(part[0], part[1], part[2]) != none;
    ASSERT_TRUE(all_there);
    ASSERT_TRUE(undo_split(task.complex, task.constraints, split));
    EXPECT_NE(task.complex.find_face(f[0], f[1], f[2]), none);
    EXPECT_EQ(task.complex.tet_at(node), none);
    EXPECT_TRUE(validate(task.complex.to_mesh()).empty());
    EXPECT_EQ(exact_six_volumes(task.complex.to_mesh()), volume);
}

TEST(Splits, AMissingPartKeepsTheNode) {
    Task task;
    TetRing ring;
    ASSERT_NE(inner_edge_tet(task.complex, ring, task.edge), none);
    const auto [a, b] = task.edge;
    task.constraints.add_facet({a, b, ring.link[0]}, 0);
    const Split split = split_segment(task.constraints, a, b, 0);  // a node far away: no part is there
    const std::vector<Tet> before = task.complex.to_mesh().tets;
    EXPECT_FALSE(undo_split(task.complex, task.constraints, split));
    EXPECT_EQ(task.complex.to_mesh().tets, before);
}

TEST(Splits, ANodeWhosePartsNeverCameLeavesAllTheSame) {
    Task task;
    TetRing ring;
    ASSERT_NE(inner_edge_tet(task.complex, ring, task.edge), none);
    const auto [a, b] = task.edge;
    const std::string volume = exact_six_volumes(task.complex.to_mesh());
    const Vec3 place = round_to_float(task.complex.position(a) * 0.7 + task.complex.position(b) * 0.3);
    const Index node = insert_node(task.complex, {}, place, all_holders(task.complex, place));
    ASSERT_NE(node, none);
    task.constraints.add_facet({a, b, 63}, 0);  // a facet to somewhere else
    const Split split = split_segment(task.constraints, a, b, node);
    ASSERT_FALSE(undo_split(task.complex, task.constraints, split));
    ASSERT_TRUE(drop_split(task.complex, task.constraints, split));
    EXPECT_EQ(task.complex.tet_at(node), none);
    EXPECT_TRUE(task.constraints.has_facet(a, b, 63));
    EXPECT_TRUE(validate(task.complex.to_mesh()).empty());
    EXPECT_EQ(exact_six_volumes(task.complex.to_mesh()), volume);
}

TEST(Splits, ANodeThatWasSplitAtFurtherWaits) {
    Constraints constraints;
    constraints.add_facet({0, 1, 2}, 0);
    const Split first = split_segment(constraints, 0, 1, 10);
    split_segment(constraints, 0, 10, 11);
    TetComplex complex(shapes::tet_grid(2));
    EXPECT_FALSE(undo_split(complex, constraints, first));
}

}
