// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "quality/tet_measures.h"

namespace crumple::finish {
namespace {

constexpr Vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

Vec3 random_place(Rng& rng) { return {rng.next_unit(), rng.next_unit(), rng.next_unit()}; }

TEST(Shape, OfATetWithoutVolumeOrTurnedInsideOutIsZero) {
    EXPECT_EQ(shape_of(o, o, o, o), 0);
    EXPECT_EQ(shape_of(o, x, y, x + y), 0);
    EXPECT_EQ(shape_of(o, y, x, z), 0);
    EXPECT_EQ(shape_of(o, x, y, {0, 0, std::nan("")}), 0);
    EXPECT_GT(shape_of(o, x, y, z), 0);
}

TEST(Shape, OfARegularTetIsTheSineOfItsAngle) {
    const Vec3 a{1, 1, 1}, b{1, -1, -1}, c{-1, 1, -1}, d{-1, -1, 1};
    const double angle = std::acos(1.0 / 3);
    EXPECT_NEAR(std::max(shape_of(a, b, c, d), shape_of(a, b, d, c)), std::sin(angle), 1e-12);
}

// The corner of a cube: three right angles, three of acos(1 / sqrt(3)), mean ratio 12 (1 / 4)^(1/3) / 9.
TEST(Shape, OfACubesCornerFollowsTheFormula) {
    const double sine = std::sqrt(2.0 / 3);
    EXPECT_NEAR(shape_of(o, x, y, z), std::min(sine, mean_ratio_weight * 12 * std::cbrt(0.25) / 9), 1e-12);
}

TEST(Shape, DoesNotDependOnSizeOrOnTheOrderOfCorners) {
    Rng rng(5);
    for (int round = 0; round < 200; ++round) {
        const Vec3 a = random_place(rng), b = random_place(rng), c = random_place(rng), d = random_place(rng);
        const double shape = std::max(shape_of(a, b, c, d), shape_of(a, b, d, c));
        EXPECT_NEAR(std::max(shape_of(c, a, b, d), shape_of(c, a, d, b)), shape, 1e-9);
        EXPECT_EQ(std::max(shape_of(a * 1024, b * 1024, c * 1024, d * 1024),
                           shape_of(a * 1024, b * 1024, d * 1024, c * 1024)),
                  shape);
        const double tiny = 0x1p-60;
        EXPECT_EQ(std::max(shape_of(a * tiny, b * tiny, c * tiny, d * tiny),
                           shape_of(a * tiny, b * tiny, d * tiny, c * tiny)),
                  shape);
    }
}

TEST(Shape, IsNoBetterThanTheSineOfTheSmallestAngle) {
    Rng rng(6);
    for (int round = 0; round < 2000; ++round) {
        const Vec3 a = random_place(rng), b = random_place(rng), c = random_place(rng), d = random_place(rng);
        const double key = quality::min_dihedral_key(a, b, c, d);
        if (key > 1) continue;
        EXPECT_LE(shape_of(a, b, c, d), std::sqrt(key) * (1 + 1e-12));
    }
}

TEST(Shape, IsTheLeastOfItsTermsAndTheirGradientsPointWhereTheyGrow) {
    Rng rng(7);
    int compared = 0;
    while (compared < 200) {
        const Vec3 a = random_place(rng), b = random_place(rng), c = random_place(rng), d = random_place(rng);
        if (shape_of(a, b, c, d) < 0.05) continue;
        ++compared;
        const ShapeTerms terms = shape_terms(a, b, c, d);
        EXPECT_NEAR(*std::min_element(terms.value, terms.value + 7), shape_of(a, b, c, d), 1e-12);
        const double step = 1e-6;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 along{};
            (axis == 0 ? along.x : axis == 1 ? along.y : along.z) = step;
            const ShapeTerms more = shape_terms(a + along, b, c, d);
            const ShapeTerms less = shape_terms(a - along, b, c, d);
            for (int i = 0; i < 7; ++i) {
                // A sine jumps to its biased self at a right angle.
                if (std::abs(more.value[i] - less.value[i]) > 0.1) continue;
                const double slope = (more.value[i] - less.value[i]) / (2 * step);
                EXPECT_NEAR(terms.gradient[i][axis], slope, 1e-5 * (1 + std::abs(slope))) << i;
            }
        }
    }
}

TEST(Shape, KnowsSinesAndCubeRootsWithoutLibm) {
    for (double degrees = 0; degrees <= 90; degrees += 0.25)
        EXPECT_NEAR(shape_of_angle(degrees), std::sin(degrees * std::numbers::pi / 180), 1e-15);
    EXPECT_EQ(shape_of_angle(-5), 0);
    for (double v = 1e-30; v < 1e30; v *= 1.7) EXPECT_NEAR(cube_root(v) / std::cbrt(v), 1, 1e-14);
}

}
}
