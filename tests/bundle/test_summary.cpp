// SPDX-License-Identifier: MIT
#include "bundle/summary.h"

#include <gtest/gtest.h>

#include "bundle/small_bundle.h"

using namespace crumple;

TEST(Summary, OfNothingIsAllZeros) {
    const BundleSummary s = summarize(Bundle{});
    EXPECT_EQ(s.nodes, 0u);
    EXPECT_EQ(s.mass_kg, 0);
}

TEST(Summary, CountsWhatTheTowerHolds) {
    const BundleSummary s = summarize(test::small_bundle(3));
    EXPECT_EQ(s.nodes, 16u);
    EXPECT_EQ(s.locked_nodes, 8u);
    EXPECT_EQ(s.unused_locked_nodes, 0u);
    EXPECT_EQ(s.tets, 15u);
    EXPECT_EQ(s.solver_tets, 10u);
    EXPECT_NEAR(s.volume_m3, 3, 1e-6);
    EXPECT_NEAR(s.mass_kg, 3000, 1e-3) << "steel-like material weighs 1000 kg a cubic metre";
    EXPECT_EQ(s.box_high, (Vec3{1, 3, 1}));
    ASSERT_EQ(s.visuals.size(), 1u);
    EXPECT_EQ(s.visuals[0].outside, 1u);
    EXPECT_EQ(s.visuals[0].max_distance, 0.5);
    EXPECT_EQ(s.visuals[0].max_abs_weight, 1.5);
    ASSERT_EQ(s.sensors.size(), 1u);
    EXPECT_EQ(s.sensors[0].nodes, 8u);
}
