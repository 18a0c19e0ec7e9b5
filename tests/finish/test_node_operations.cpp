// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/node_operations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

std::vector<Index> all_tets(const TetMesh& mesh) {
    std::vector<Index> tets(mesh.tets.size());
    std::iota(tets.begin(), tets.end(), Index{0});
    return tets;
}

TEST(NodeOperations, OnlyInteriorNodesOfOneMaterialAreFree) {
    TetMesh mesh = small::box_around({0.4, 0.5, 0.6});
    WorkMesh work(mesh);
    for (Index v = 0; v < 8; ++v) EXPECT_FALSE(work.is_free[v]);
    EXPECT_TRUE(work.is_free[8]);
    mesh.region[5] = 1;
    EXPECT_FALSE(WorkMesh(mesh).is_free[8]);
    mesh.region[5] = 0;
    mesh.shell_vertex_count = 9;
    EXPECT_FALSE(WorkMesh(mesh).is_free[8]);
    mesh.shell_vertex_count = 8;
    mesh.tets.erase(mesh.tets.begin());
    mesh.region.pop_back();
    mesh.neighbours = neighbours_of(mesh.tets);
    EXPECT_FALSE(WorkMesh(mesh).is_free[8]) << "it is on the surface now";
}

TEST(NodeOperations, AMoveMakesTheWorstTetOfTheStarBetter) {
    const TetMesh mesh = small::box_around({0.9, 0.85, 0.9});
    WorkMesh work(mesh);
    const double before = small::worst_of(mesh);
    const auto better = plan_move(work, 8, all_tets(mesh), before);
    ASSERT_TRUE(better);
    move_node(work, 8, better->place, all_tets(mesh));
    const TetMesh moved = take_mesh(work);
    EXPECT_GT(small::worst_of(moved), before);
    EXPECT_EQ(small::worst_of(moved), better->least);
    EXPECT_TRUE(small::is_all_positive(moved));
    EXPECT_NEAR(small::volume_of(moved), 1, 1e-12);
}

TEST(NodeOperations, ANodeOfASplitTetMergesAwayIntoACorner) {
    // A tet cut into four by a node near one of its faces: without the node there is one good tet.
    const TetMesh mesh = small::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25, 0.25, 0.01}},
                                        {{4, 1, 2, 3}, {0, 4, 2, 3}, {0, 1, 4, 3}, {0, 1, 2, 4}}, 4);
    ASSERT_TRUE(small::is_all_positive(mesh));
    WorkMesh work(mesh);
    Exchange exchange;
    ASSERT_TRUE(plan_contraction(work, 4, all_tets(mesh), 3, small::worst_of(mesh), exchange));
    (void)apply(work, exchange);
    const TetMesh merged = take_mesh(work);
    ASSERT_EQ(merged.tets.size(), 1u);
    EXPECT_EQ(merged.positions.size(), 4u) << "a node without tets is dropped";
    EXPECT_NEAR(small::volume_of(merged), 1.0 / 6, 1e-12);
}

TEST(NodeOperations, AContractionThatTurnsATetInsideOutIsRefused) {
    // The star of the node is not convex: seen from node 1 the dented side is behind.
    TetMesh mesh = small::box_around({0.5, 0.5, 0.5});
    mesh.positions[0] = {0.45f, 0.45f, 0.45f};
    ASSERT_TRUE(small::is_all_positive(mesh));
    const WorkMesh work(mesh);
    Exchange exchange;
    EXPECT_FALSE(plan_contraction(work, 8, all_tets(mesh), 1, 0, exchange));
}

TEST(NodeOperations, AContractionWorseThanTheFloorIsRefused) {
    const TetMesh mesh = small::box_around({0.5, 0.5, 0.5});
    const WorkMesh work(mesh);
    Exchange exchange;
    EXPECT_FALSE(plan_contraction(work, 8, all_tets(mesh), 0, 0.99, exchange));
}

}
}
