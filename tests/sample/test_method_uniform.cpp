// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "mesh/shapes.h"
#include "sample/sample.h"

using namespace crumple;
using namespace crumple::sample;

namespace {

TEST(Uniform, DensityIsTheSameEverywhere) {
    // A sphere in the box makes h vary; points must not care.
    const Shell shell =
        shapes::joined(shapes::subdivided_box(4, {0, 0, 0}, {4, 1, 1}), shapes::icosphere(0.1, 2, {0.5, 0.5, 0.5}));
    Params params;
    params.points = "8000";
    params.method = Method::uniform;
    params.clearance = 0;
    const Result result = sample_interior(shell, params);
    ASSERT_EQ(result.report.points, 8000u);
    EXPECT_EQ(result.report.spacing, 0);
    std::array<int, 8> hits{};
    for (std::size_t i = result.points.shell_vertex_count; i < result.points.positions.size(); ++i) {
        ++hits[static_cast<std::size_t>(result.points.positions[i].x * 2)];
    }
    // 1000 each, standard deviation 30; five of them.
    for (const int hit : hits) EXPECT_NEAR(hit, 1000, 150);
}

TEST(Uniform, FewerPointsAreThePrefixOfMore) {
    const Shell shell = shapes::icosphere(1, 3);
    Params params;
    params.method = Method::uniform;
    params.points = "50";
    const Result few = sample_interior(shell, params);
    params.points = "60";
    const Result more = sample_interior(shell, params);
    for (std::size_t i = 0; i < few.points.positions.size(); ++i) {
        EXPECT_EQ(few.points.positions[i], more.points.positions[i]);
    }
}

}
