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

TEST(ShellInterior, ThousandsOfPiecesAnswerAsOneWould) {
    Shell pieces;
    for (int x = 0; x < 12; ++x) {
        for (int y = 0; y < 12; ++y) {
            for (int z = 0; z < 12; ++z) {
                const Vec3 low{x * 2.0, y * 2.0, z * 2.0};
                pieces = shapes::joined(std::move(pieces),
                                        shapes::without_triangle(shapes::box(low, low + Vec3{1, 1, 1}), 0));
            }
        }
    }
    const ShellInterior interior(pieces);
    for (Index c = 0; c < pieces.components.size(); c += 100) {
        const Vec3 low = pieces.positions[c * 8];
        EXPECT_EQ(interior.innermost(low + Vec3{0.5, 0.5, 0.5}), c);
        EXPECT_EQ(interior.innermost(low + Vec3{0.5, 0.5, 0.5}, c), none);
        EXPECT_EQ(interior.innermost(low + Vec3{1.5, 0.5, 0.5}), none);
        EXPECT_NEAR(interior.material_winding(low + Vec3{0.5, 0.5, 0.5}), 11 / 12.0, 0.02);
        EXPECT_EQ(interior.by_volume()[interior.rank(c)], c);
    }
}

TEST(ShellInterior, KnowsWhatLiesOnASurface) {
    const ShellInterior interior(shapes::nested_boxes(Role::cavity));
    EXPECT_TRUE(interior.is_on_surface({1, 1.5, 1.25}));
    EXPECT_TRUE(interior.is_on_surface({3, 3, 3}));
    EXPECT_FALSE(interior.is_on_surface({1.5, 1.5, 1.5}));
}

}
}
