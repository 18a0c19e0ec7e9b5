// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/measures.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace crumple {
namespace {

Vec3 random_point(Rng& rng) {
    const double x = rng.next_unit();
    const double y = rng.next_unit();
    return {x, y, rng.next_unit()};
}

TEST(Measures, BarycentricWeightsDescribeThePointInsideAndOutside) {
    Rng rng(1);
    for (int i = 0; i < 200; ++i) {
        const Vec3 far{1e4, -1e4, 1e4};  // rounding errors must be of the tet's size, not of its place
        const Vec3 a = far + random_point(rng), b = far + random_point(rng), c = far + random_point(rng),
                   d = far + random_point(rng);
        const double volume = signed_volume(a, b, c, d);
        if (std::fabs(volume) < 1e-3) continue;
        const Vec3 p = far + random_point(rng) * 3;
        const auto w = barycentric(a, b, c, d, p);
        EXPECT_NEAR(w[0] + w[1] + w[2] + w[3], 1, 1e-12);
        EXPECT_NEAR(length(a * w[0] + b * w[1] + c * w[2] + d * w[3] - p), 0, 1e-8);
    }
}

TEST(Measures, CornersHaveWeightOne) {
    const Vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < 4; ++i) {
        const auto w = barycentric(corners[0], corners[1], corners[2], corners[3], corners[i]);
        for (int j = 0; j < 4; ++j) EXPECT_EQ(w[j], i == j ? 1 : 0);
    }
}

TEST(Measures, CircumcentreIsEquallyFarFromAllCorners) {
    const Vec3 a{0, 0, 0}, b{2, 0, 0}, c{0, 4, 0}, d{0, 0, 6};
    EXPECT_EQ(circumcentre(a, b, c, d), (Vec3{1, 2, 3}));
}

TEST(Measures, ClosestPointOnATriangleIsTheBestOfManyOfItsPoints) {
    Rng rng(3);
    for (int i = 0; i < 100; ++i) {
        const Vec3 a = random_point(rng), b = random_point(rng), c = random_point(rng);
        const Vec3 p = random_point(rng) * 3 - Vec3{1, 1, 1};
        const double found = length(closest_point_on_triangle(a, b, c, p) - p);
        for (int u = 0; u <= 10; ++u) {
            for (int v = 0; u + v <= 10; ++v) {
                EXPECT_LE(found, length(a + (b - a) * (u / 10.0) + (c - a) * (v / 10.0) - p) + 1e-12);
            }
        }
    }
}

TEST(Measures, ClosestPointOnATriangleWithoutAreaIsOnItsLongestEdge) {
    EXPECT_EQ(closest_point_on_triangle({0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 1, 0}), (Vec3{2, 0, 0}));
    EXPECT_EQ(closest_point_on_triangle({1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {2, 1, 0}), (Vec3{1, 1, 1}));
}

TEST(Measures, TheBoxOfNothingHasNoSize) { EXPECT_EQ(bounding_box(std::array<Vec3, 0>{}).diagonal(), 0); }

}
}
