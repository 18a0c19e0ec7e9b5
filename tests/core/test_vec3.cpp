// SPDX-License-Identifier: MIT
#include "core/vec3.h"

#include <gtest/gtest.h>

#include <limits>

using namespace crumple;

namespace {

TEST(Vec3, MinusZeroEqualsZero) {
    EXPECT_EQ((Vec3{0.0, -0.0, 0.0}), (Vec3{-0.0, 0.0, -0.0}));
    EXPECT_FALSE(lexicographic_less(Vec3{-0.0, 0, 0}, Vec3{0.0, 0, 0}));
    EXPECT_FALSE(lexicographic_less(Vec3{0.0, 0, 0}, Vec3{-0.0, 0, 0}));
}

TEST(Vec3, OrderIsByXThenYThenZ) {
    EXPECT_TRUE(lexicographic_less(Vec3{0, 9, 9}, Vec3{1, 0, 0}));
    EXPECT_TRUE(lexicographic_less(Vec3{1, 0, 9}, Vec3{1, 1, 0}));
    EXPECT_TRUE(lexicographic_less(Vec3{1, 1, 0}, Vec3{1, 1, 1}));
    EXPECT_FALSE(lexicographic_less(Vec3{1, 1, 1}, Vec3{1, 1, 1}));
}

TEST(Vec3, AxesAreReadAndWrittenByNumber) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = axis + 1;
    EXPECT_EQ(p, (Vec3{1, 2, 3}));
    const Vec3 q = p;
    EXPECT_EQ(q[0] + q[1] * 10 + q[2] * 100, 321);
}

TEST(Vec3, CrossIsRightHandedAndNormal) {
    EXPECT_EQ(cross(Vec3{1, 0, 0}, Vec3{0, 1, 0}), (Vec3{0, 0, 1}));
    const Vec3 a{1, 2, 3};
    const Vec3 b{-4, 5, 0.5};
    EXPECT_EQ(dot(cross(a, b), a), 0);
    EXPECT_EQ(dot(cross(a, b), b), 0);
}

TEST(Vec3, LengthOfAPythagoreanBoxIsExact) { EXPECT_EQ(length(Vec3{2, 3, 6}), 7); }

TEST(Vec3, RoundingToFloatIsIdempotentAndNearest) {
    const Vec3 p{0.1, -1.0 / 3, 12345.678901};
    const Vec3 q = round_to_float(p);
    EXPECT_EQ(round_to_float(q), q);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(q[axis], static_cast<double>(static_cast<float>(p[axis])));
        EXPECT_NE(q[axis], p[axis]);
        EXPECT_NEAR(q[axis], p[axis], std::abs(p[axis]) * 0x1p-24);
    }
}

TEST(Vec3, RoundingHappensAlsoWhereTheResultIsOnlyCompared) {
    // Optimizers have been seen to drop the way through float.
    for (int i = 1; i < 50; ++i) {
        const Vec3 p{1.0 / (3 * i), 1.0 / (7 * i), 1.0 / (11 * i)};
        const Vec3 q = round_to_float(p);
        EXPECT_FALSE(q == p) << i;
    }
}

}
