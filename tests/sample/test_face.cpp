// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/face.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "geometry/measures.h"

using namespace crumple;
using namespace crumple::sample;

namespace {

Vec3 random_point(Rng& rng) {
    return {rng.next_unit() * 2 - 0.5, rng.next_unit() * 2 - 0.5, rng.next_unit() * 2 - 0.5};
}

double expected_distance(Vec3 a, Vec3 b, Vec3 c, Vec3 p) { return length(closest_point_on_triangle(a, b, c, p) - p); }

TEST(Face, ATriangleWithoutAreaIsItsSides) {
    const Face needle({0, 0, 0}, {1, 0, 0}, {0.5, 0, 0});
    EXPECT_FALSE(needle.has_area);
    EXPECT_DOUBLE_EQ(needle.distance_2({0.5, 2, 0}), 4);
    EXPECT_DOUBLE_EQ(needle.distance_2({3, 0, 0}), 4);
    const Face point({1, 1, 1}, {1, 1, 1}, {1, 1, 1});
    EXPECT_DOUBLE_EQ(point.distance_2({1, 1, 3}), 4);
}

TEST(Face, DistanceAgreesWithTheClosestPoint) {
    Rng rng(31);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 a = random_point(rng);
        const Vec3 b = random_point(rng);
        const Vec3 c = random_point(rng);
        const Vec3 p = random_point(rng);
        EXPECT_NEAR(std::sqrt(Face(a, b, c).distance_2(p)), expected_distance(a, b, c, p), 1e-9);
    }
}

TEST(FaceBall, WhatItRulesOutIsFarther) {
    Rng rng(32);
    int ruled_out = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 a = random_point(rng);
        const Vec3 b = random_point(rng);
        const Vec3 c = random_point(rng);
        const Vec3 p = random_point(rng);
        const double distance = rng.next_unit();
        const FaceBall ball(a, b, c);
        if (ball.may_reach(ball.centre_distance_2(p), distance)) continue;
        ++ruled_out;
        EXPECT_GT(expected_distance(a, b, c, p), distance);
    }
    EXPECT_GT(ruled_out, 100);
}

TEST(FaceBall, FarFromTheOriginNothingIsWronglyRuledOut) {
    const Vec3 offset{1e6, -1e6, 1e6};
    const FaceBall ball(offset, offset + Vec3{0.0625, 0, 0}, offset + Vec3{0, 0.0625, 0});
    EXPECT_TRUE(ball.may_reach(ball.centre_distance_2(offset), 0));
    EXPECT_FALSE(ball.may_reach(ball.centre_distance_2(offset + Vec3{1, 0, 0}), 0.5));
}

}
