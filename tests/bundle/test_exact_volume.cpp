// SPDX-License-Identifier: MIT
#include "bundle/exact_volume.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"

using crumple::Vec3f;

TEST(ExactVolume, CoplanarCornersHaveExactlyNoVolume) {
    // Four points of the plane x + y + z = 1 whose coordinates are not round.
    const Vec3f a{0.1f, 0.2f, 0.7f};
    EXPECT_EQ(crumple::six_volumes(a, a, {1, 0, 0}, {0, 1, 0}), 0.0);
    EXPECT_EQ(crumple::six_volumes({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5f, 0.25f, 0.25f}), 0.0);
}

TEST(ExactVolume, SeesAFourthCornerOneUlpOffThePlane) {
    const Vec3f b{1, 0, 0};
    const Vec3f c{0, 1, 0};
    const Vec3f d{0, 0, 1};
    const float up = std::nextafter(0.25f, 1.0f);
    EXPECT_EQ(crumple::six_volumes(b, c, d, {0.5f, 0.25f, up}), double{up} - 0.25);
    EXPECT_EQ(crumple::six_volumes(b, d, c, {0.5f, 0.25f, up}), 0.25 - double{up});
}

TEST(ExactVolume, KeepsTheSignUnderEvenPermutationsAndTurnsItUnderOddOnes) {
    crumple::Rng rng(7);
    for (int trial = 0; trial < 2000; ++trial) {
        Vec3f p[4];
        // Nearly on one plane: z = x + y up to an ulp or so.
        for (Vec3f& q : p) {
            q.x = static_cast<float>(rng.next_unit());
            q.y = static_cast<float>(rng.next_unit());
            q.z = q.x + q.y;
        }
        const double volume = crumple::six_volumes(p[0], p[1], p[2], p[3]);
        const double close = 2e-7 * std::fabs(volume);  // so the sign is the same as well
        EXPECT_NEAR(crumple::six_volumes(p[1], p[2], p[0], p[3]), volume, close) << "trial " << trial;
        EXPECT_NEAR(crumple::six_volumes(p[1], p[0], p[3], p[2]), volume, close) << "trial " << trial;
        EXPECT_NEAR(crumple::six_volumes(p[1], p[0], p[2], p[3]), -volume, close) << "trial " << trial;
    }
}

TEST(ExactVolume, HoldsAtAnyScale) {
    for (const float scale : {1e-10f, 1e-6f, 1.0f, 1e4f, 1e10f}) {
        const double volume = crumple::six_volumes({0, 0, 0}, {scale, 0, 0}, {0, scale, 0}, {0, 0, scale});
        EXPECT_DOUBLE_EQ(volume, double{scale} * scale * scale);
    }
}

TEST(ExactVolume, InverseRestTimesEdgesIsTheIdentity) {
    const Vec3f p[4] = {{1, 2, 3}, {4, 2.5f, 3}, {1, 5, 2}, {0.5f, 2, 7}};
    const auto inverse = crumple::inverse_rest_matrix(p[0], p[1], p[2], p[3]);
    for (std::size_t row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            double sum = 0;
            for (int axis = 0; axis < 3; ++axis)
                sum += inverse[3 * row + static_cast<std::size_t>(axis)] * (p[column + 1][axis] - p[0][axis]);
            EXPECT_NEAR(sum, static_cast<int>(row) == column ? 1 : 0, 1e-14);
        }
    }
}
