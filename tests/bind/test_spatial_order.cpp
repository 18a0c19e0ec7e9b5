// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"

namespace crumple::bind {
namespace {

TEST(SpatialOrder, IsAPermutation) {
    EXPECT_TRUE(spatial_order({}).empty());
    Rng rng(1);
    std::vector<Vec3> points;
    for (int i = 0; i < 1000; ++i) {
        const double x = rng.next_unit();
        points.push_back({x, -5 * rng.next_unit(), 0});
    }
    points[17] = points[4];
    std::vector<Index> order = spatial_order(points);
    std::sort(order.begin(), order.end());
    for (Index i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

TEST(SpatialOrder, EqualPointsKeepTheirOrder) {
    const std::vector<Vec3> points(5, Vec3{1, 2, 3});
    EXPECT_EQ(spatial_order(points), (std::vector<Index>{0, 1, 2, 3, 4}));
}

TEST(SpatialOrder, ShortensTheWalk) {
    Rng rng(2);
    std::vector<Vec3> points;
    for (int i = 0; i < 5000; ++i) {
        const double x = rng.next_unit();
        const double y = rng.next_unit();
        points.push_back({x, y, rng.next_unit()});
    }
    const std::vector<Index> order = spatial_order(points);
    double before = 0;
    double after = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        before += length(points[i] - points[i - 1]);
        after += length(points[order[i]] - points[order[i - 1]]);
    }
    EXPECT_LT(after, before / 5);
}

}
}
