// SPDX-License-Identifier: GPL-3.0-or-later
#include "cull/shell_solid.h"

#include <gtest/gtest.h>

#include "mesh/shapes.h"

namespace crumple::cull {
namespace {

ShellSolid study(const Shell& shell) { return study_solid(shell, ShellInterior(shell)); }

TEST(ShellSolid, CavitiesCountOffAndEmbeddedPartsDoNotCountTwice) {
    EXPECT_NEAR(study(shapes::nested_boxes(Role::cavity)).volume, 26, 1e-12);
    EXPECT_NEAR(study(shapes::nested_boxes(Role::rigid)).volume, 27, 1e-12);
    EXPECT_TRUE(study(shapes::nested_boxes(Role::rigid)).is_exact());
}

TEST(ShellSolid, APartInsideACavityCountsAgain) {
    const Shell shell =
        shapes::joined(shapes::nested_boxes(Role::cavity), shapes::box({1.25, 1.25, 1.25}, {1.75, 1.75, 1.75}));
    const ShellSolid solid = study(shell);
    EXPECT_NEAR(solid.volume, 26.125, 1e-12);
    EXPECT_EQ(solid.pieces, 2u);
}

TEST(ShellSolid, ACavityInNothingIsNothing) {
    Shell shell = shapes::box();
    shell.components[0].role = Role::cavity;
    EXPECT_EQ(study(shell).volume, 0);
    EXPECT_EQ(study(shell).pieces, 0u);
}

TEST(ShellSolid, OpenCrossingAndTouchingShellsAreNotExact) {
    EXPECT_FALSE(study(shapes::without_triangle(shapes::icosphere())).is_exact());
    const Shell crossing = shapes::joined(shapes::box(), shapes::box({0.5, 0.5, 0.5}, {2, 2, 2}));
    EXPECT_TRUE(study(crossing).all_closed);
    EXPECT_FALSE(study(crossing).is_exact());
    EXPECT_EQ(study(crossing).pieces, 1u);
    EXPECT_FALSE(study(shapes::joined(shapes::box(), shapes::box({1, 0, 0}, {2, 1, 1}))).is_exact());
}

TEST(ShellSolid, SeparatePartsAndEmbeddedPartsAreCounted) {
    EXPECT_EQ(study(shapes::joined(shapes::box(), shapes::box({5, 5, 5}, {6, 6, 6}))).pieces, 2u);
    EXPECT_EQ(study(shapes::nested_boxes(Role::solid)).pieces, 1u);
    EXPECT_EQ(study(shapes::nested_boxes(Role::cavity)).pieces, 1u);
}

TEST(ShellSolid, ComponentsWoundInwardsHaveTheSameVolume) {
    EXPECT_NEAR(study(shapes::inverted(shapes::nested_boxes(Role::cavity))).volume, 26, 1e-12);
}

}
}
