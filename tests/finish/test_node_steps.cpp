// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/node_steps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

TEST(NodeSteps, OfNothingAreNone) { EXPECT_EQ(NodeSteps(WorkMesh(TetMesh())).node_count(), 0u); }

TEST(NodeSteps, OfASingleTetAreItsHeightsThird) {
    // One tet: sqrt(V / (A^2 / V)) = V / A with A twice the area; h = 3 V / (A / 2).
    const TetMesh mesh = small::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}, {9, 9, 9}}, {{0, 1, 2, 3}}, 5);
    const NodeSteps steps{WorkMesh(mesh)};
    EXPECT_NEAR(steps.step(3), 0.5 / 6, 1e-12);
    EXPECT_NEAR(steps.step(1), 1.0 / 6, 1e-12);
    EXPECT_EQ(steps.step(4), 0) << "no tet has it";
}

TEST(NodeSteps, WeighAsIfTheChangeWereDone) {
    const TetMesh mesh = small::box_around({0.3, 0.4, 0.45});
    WorkMesh work(mesh);
    NodeSteps steps(work);
    Change move;
    move.is_placed = true;
    move.placed = 8;
    move.place = {0.5, 0.5, 0.5};
    for (Index t = 0; t < mesh.tets.size(); ++t) {
        move.exchange.old.push_back(t);
        move.exchange.fresh.push_back(mesh.tets[t]);
    }
    const NodeSteps::Least least = steps.weigh(work, move);
    TetMesh moved = mesh;
    moved.positions[8] = move.place;
    const NodeSteps before{WorkMesh(mesh)};
    const NodeSteps after{WorkMesh(moved)};
    double least_before = 1e300;
    double least_after = 1e300;
    for (Index v = 0; v < 9; ++v) {
        least_before = std::min(least_before, before.step(v));
        least_after = std::min(least_after, after.step(v));
    }
    EXPECT_NEAR(least.before, least_before, 1e-12);
    EXPECT_NEAR(least.after, least_after, 1e-12);
    steps.carry_out(work, move, none);
    for (Index v = 0; v < 9; ++v) EXPECT_NEAR(steps.step(v), after.step(v), 1e-12) << v;
}

TEST(NodeSteps, AnAddedNodeCountsToo) {
    const TetMesh mesh = small::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}, 4);
    WorkMesh work(mesh);
    NodeSteps steps(work);
    Change add;
    add.is_placed = true;
    add.place = {0.25, 0.25, 0.0001};
    add.exchange.old = {0};
    add.exchange.fresh = {{none, 1, 2, 3}, {0, none, 2, 3}, {0, 1, none, 3}, {0, 1, 2, none}};
    EXPECT_LT(steps.weigh(work, add).after, steps.weigh(work, add).before);
    steps.carry_out(work, add, 4);
    ASSERT_EQ(steps.node_count(), 5u);
    EXPECT_GT(steps.step(4), 0);
    EXPECT_LT(steps.step(4), steps.step(0) * 2);
}

}
}
