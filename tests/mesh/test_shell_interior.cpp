// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/shell_interior.h"

#include <gtest/gtest.h>

#include "mesh/shapes.h"

namespace crumple {
namespace {

TEST(ShellInterior, NothingContainsAPointOfAnEmptyShell) {
    const ShellInterior interior(Shell{});
    EXPECT_EQ(interior.innermost({0, 0, 0}), none);
}

TEST(ShellInterior, TheInnermostComponentDecides) {
    const ShellInterior cavity(shapes::nested_boxes(Role::cavity));
    EXPECT_EQ(cavity.innermost({1.5, 1.5, 1.5}), 1u);
    EXPECT_EQ(cavity.material_at({1.5, 1.5, 1.5}), none);
    EXPECT_EQ(cavity.material_at({0.5, 0.5, 0.5}), 0u);
    EXPECT_EQ(cavity.material_at({-0.5, 0.5, 0.5}), none);
    const ShellInterior engine(shapes::nested_boxes(Role::rigid));
    EXPECT_EQ(engine.material_at({1.5, 1.5, 1.5}), 1u);
}

TEST(ShellInterior, TheOrderOfComponentsDoesNotMatter) {
    Shell inner = shapes::box({1, 1, 1}, {2, 2, 2});
    inner.components[0].role = Role::cavity;
    const ShellInterior interior(shapes::joined(inner, shapes::box({0, 0, 0}, {3, 3, 3})));
    EXPECT_EQ(interior.innermost({1.5, 1.5, 1.5}), 0u);
    EXPECT_EQ(interior.material_at({0.5, 0.5, 0.5}), 1u);
}

TEST(ShellInterior, AComponentWoundInwardsContainsTheSamePoints) {
    const ShellInterior interior(shapes::inverted(shapes::icosphere()));
    EXPECT_EQ(interior.innermost({0.1, 0.2, 0.3}), 0u);
    EXPECT_EQ(interior.innermost({1, 1, 1}), none);
}

TEST(ShellInterior, ASmallHoleIsForgiven) {
    const ShellInterior interior(shapes::without_triangle(shapes::icosphere(1, 3)));
    EXPECT_EQ(interior.innermost({0, 0, 0}), 0u);
    EXPECT_EQ(interior.innermost({0, 2, 0}), none);
    EXPECT_NEAR(interior.winding(0, {0, 0, 0}), 1 - 1 / 1280.0, 2e-4);
}

}
}
