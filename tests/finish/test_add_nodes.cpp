// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/add_nodes.h"

#include <gtest/gtest.h>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

constexpr std::uint64_t generous = 100'000;

TEST(AddNodes, ToNothingIsNothing) {
    WorkMesh work{TetMesh()};
    const NodeReport report = NodeAdder(work, {}).run(0, generous, {});
    EXPECT_EQ(report.added + report.reseated + report.tried, 0u);
    EXPECT_FALSE(report.is_out_of_budget);
}

TEST(AddNodes, AMeshWithoutBadTetsStaysAsItIs) {
    const TetMesh mesh = small::box_around({0.5, 0.5, 0.5});
    WorkMesh work(mesh);
    EXPECT_EQ(NodeAdder(work, {}).run(0, generous, {}).tried, 0u);
    EXPECT_EQ(take_mesh(work).tets, mesh.tets);
}

TEST(AddNodes, BadTetsGetANodeAndBecomeFewer) {
    const TetMesh mesh = small::ring(8, 3);
    WorkMesh work(mesh);
    const NodeReport report = NodeAdder(work, {.bad_deg = 24, .price = 0.5}).run(0, generous, {});
    EXPECT_GE(report.added, 1u);
    const TetMesh result = take_mesh(work);
    EXPECT_TRUE(small::is_all_positive(result));
    EXPECT_NEAR(small::volume_of(result), small::volume_of(mesh), 1e-5);
    EXPECT_GE(small::worst_of(result), small::worst_of(mesh));
}

TEST(AddNodes, TheDearerTheFewer) {
    const TetMesh mesh = small::ring(8, 3);
    WorkMesh work(mesh);
    NodeAdder adder(work, {.bad_deg = 24, .price = 100});
    EXPECT_EQ(adder.run(0, generous, {}).added, 0u);
    WorkMesh again(mesh);
    NodeAdder level(again, {.bad_deg = 24, .price = 0.5});
    EXPECT_EQ(level.run(100, generous, {}).added, 0u);
    EXPECT_GE(level.run(0, generous, {}).added, 1u) << "what a run leaves the next may take";
}

TEST(AddNodes, ANodeInACornerIsMovedRatherThanJoinedByAnother) {
    const TetMesh mesh = small::box_around({0.97, 0.96, 0.95});
    WorkMesh work(mesh);
    const NodeReport report = NodeAdder(work, {.bad_deg = 10, .price = 3}).run(0, generous, {});
    EXPECT_EQ(report.added, 0u);
    EXPECT_GE(report.reseated, 1u);
    const TetMesh result = take_mesh(work);
    EXPECT_EQ(result.positions.size(), mesh.positions.size());
    EXPECT_GT(small::worst_of(result), small::worst_of(mesh));
}

TEST(AddNodes, ABudgetEndsIt) {
    const TetMesh mesh = small::ring(8, 3);
    WorkMesh work(mesh);
    const NodeReport report = NodeAdder(work, {.bad_deg = 24, .price = 0.5}).run(0, 1, {});
    EXPECT_TRUE(report.is_out_of_budget);
    EXPECT_EQ(report.tried, 0u);
    EXPECT_EQ(take_mesh(work).tets, mesh.tets);
}

}
}
