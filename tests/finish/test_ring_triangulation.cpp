// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/ring_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/random.h"
#include "finish/shape.h"

namespace crumple::finish {
namespace {

constexpr Vec3 below{0, 0, -1}, above{0, 0, 1};

std::vector<Vec3> regular_ring(int n, double radius = 1) {
    std::vector<Vec3> ring;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    return ring;
}

std::vector<Vec3> bent_ring(int n, Rng& rng) {
    std::vector<Vec3> ring = regular_ring(n);
    for (Vec3& p : ring) {
        p = p * (0.6 + 0.8 * rng.next_unit());
        p.z = 0.6 * (rng.next_unit() - 0.5);
    }
    return ring;
}

double worst_of_triangle(const std::vector<Vec3>& ring, int i, int j, int k) {
    return std::min(shape_of(ring[i], ring[j], ring[k], above), shape_of(ring[i], ring[k], ring[j], below));
}

// Every triangulation of ring[i..j], one after the other.
double best_by_trying_all(const std::vector<Vec3>& ring, int i, int j) {
    if (j < i + 2) return 1;
    double best = 0;
    for (int k = i + 1; k < j; ++k) {
        const double here = std::min(
            {worst_of_triangle(ring, i, k, j), best_by_trying_all(ring, i, k), best_by_trying_all(ring, k, j)});
        best = std::max(best, here);
    }
    return best;
}

TEST(RingTriangulation, ARingOfFewerThanThreeOrFarTooManyIsLeftAlone) {
    RingTriangulation best;
    EXPECT_FALSE(triangulate_ring(below, above, {}, 0, best));
    EXPECT_FALSE(triangulate_ring(below, above, regular_ring(2), 0, best));
    EXPECT_FALSE(triangulate_ring(below, above, regular_ring(max_ring + 1), 0, best));
    EXPECT_TRUE(best.triangles.empty());
    EXPECT_TRUE(triangulate_ring(below, above, regular_ring(max_ring), 0, best));
}

TEST(RingTriangulation, ARingWhereEveryTetWouldBeFlatIsLeftAlone) {
    RingTriangulation best;
    EXPECT_FALSE(triangulate_ring({0, 0, 0}, {0, 0, 0}, regular_ring(5), 0, best));
    EXPECT_FALSE(triangulate_ring(above, below, regular_ring(5), 0, best)) << "the edge is the other way round";
}

TEST(RingTriangulation, EqualsTheBestOfAllTriangulations) {
    Rng rng(11);
    for (int n = 3; n <= 8; ++n) {
        for (int round = 0; round < 40; ++round) {
            const std::vector<Vec3> ring = bent_ring(n, rng);
            const double wanted = best_by_trying_all(ring, 0, n - 1);
            RingTriangulation best;
            const bool is_found = triangulate_ring(below, above, ring, 0, best);
            EXPECT_EQ(is_found, wanted > 0);
            if (!is_found) continue;
            EXPECT_EQ(best.least, wanted);
            ASSERT_EQ(best.triangles.size(), static_cast<std::size_t>(n - 2));
            double least = 1;
            for (const auto& [i, j, k] : best.triangles) least = std::min(least, worst_of_triangle(ring, i, j, k));
            EXPECT_EQ(least, wanted);
        }
    }
}

TEST(RingTriangulation, OnlyWhatBeatsTheFloorCounts) {
    Rng rng(12);
    const std::vector<Vec3> ring = bent_ring(6, rng);
    RingTriangulation best;
    ASSERT_TRUE(triangulate_ring(below, above, ring, 0, best));
    const double least = best.least;
    EXPECT_FALSE(triangulate_ring(below, above, ring, least, best));
    EXPECT_TRUE(triangulate_ring(below, above, ring, least * 0.999, best));
    EXPECT_EQ(best.least, least);
}

}
}
