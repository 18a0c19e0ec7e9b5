// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/raise_steps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "finish/node_steps.h"
#include "mesh/shapes.h"
#include "small_meshes.h"

namespace crumple::finish {
namespace {

constexpr StepLimits generous{.share = 1, .budget = 100'000};

double least_step(const TetMesh& mesh) {
    const NodeSteps steps{WorkMesh(mesh)};
    double least = 1e300;
    for (Index v = 0; v < steps.node_count(); ++v) {
        if (steps.step(v) > 0) least = std::min(least, steps.step(v));
    }
    return least;
}

TEST(RaiseSteps, OfNothingIsNothing) {
    WorkMesh work{TetMesh()};
    const Shell shell;
    EXPECT_EQ(raise_steps(work, SurfaceGuard(shell, {}), generous, {}).changes, 0u);
}

TEST(RaiseSteps, ANodeNearAWallMovesAway) {
    const TetMesh mesh = small::box_around({0.5, 0.5, 0.2});
    WorkMesh work(mesh);
    const StepReport report = raise_steps(work, SurfaceGuard(small::shell_of(mesh), {}), generous, {});
    EXPECT_GT(report.changes, 0u);
    EXPECT_GT(report.tried, 0u);
    const TetMesh raised = take_mesh(work);
    EXPECT_GT(least_step(raised), 1.05 * least_step(mesh));
    EXPECT_TRUE(small::is_all_positive(raised));
    EXPECT_NEAR(small::volume_of(raised), 1, 1e-6);
    EXPECT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.begin() + 8, raised.positions.begin()));
}

TEST(RaiseSteps, NodesThatAreNoWorseThanOthersAreLeftAlone) {
    const TetMesh mesh = small::box_around({0.5, 0.5, 0.2});
    WorkMesh work(mesh);
    StepLimits limits = generous;
    limits.share = 0.01;
    EXPECT_EQ(raise_steps(work, SurfaceGuard(small::shell_of(mesh), {}), limits, {}).changes, 0u);
    limits = generous;
    limits.budget = 0;
    EXPECT_EQ(raise_steps(work, SurfaceGuard(small::shell_of(mesh), {}), limits, {}).changes, 0u);
    EXPECT_EQ(take_mesh(work).tets, mesh.tets);
}

TEST(RaiseSteps, NoGoodTetBecomesABadOne) {
    const double bad = shape_of_angle(10);
    for (const double height : {0.15, 0.3, 0.45}) {
        const TetMesh mesh = small::box_around({0.4, 0.55, height});
        WorkMesh work(mesh);
        (void)raise_steps(work, SurfaceGuard(small::shell_of(mesh), {}), generous, {});
        EXPECT_GE(small::worst_of(take_mesh(work)), std::min(bad, small::worst_of(mesh)));
    }
}

}
}
