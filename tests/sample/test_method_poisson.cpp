// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/shapes.h"
#include "sample/element_size.h"
#include "sample/sample.h"

using namespace crumple;
using namespace crumple::sample;

namespace {

Result sample_count(const Shell& shell, std::string count) {
    Params params;
    params.points = std::move(count);
    return sample_interior(shell, params);
}

// Fine at one end, coarse at the other.
Shell graded_shell() { return shapes::joined(shapes::icosphere(1, 2), shapes::icosphere(0.25, 2, {0, 0, 0})); }

TEST(Poisson, NoTwoPointsAreNearerThanTheSpacingTold) {
    for (const Shell& shell : {shapes::icosphere(1, 3), graded_shell()}) {
        const shapes::ElementSize size(shell);
        const Result result = sample_count(shell, "400");
        const auto first = result.points.positions.begin() + result.points.shell_vertex_count;
        const std::vector<Vec3> points(first, result.points.positions.end());
        ASSERT_EQ(points.size(), 400u);
        ASSERT_GT(result.report.spacing, 0);
        std::vector<double> sizes;
        for (const Vec3 p : points) sizes.push_back(size.at(p));
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const double least = result.report.spacing * std::min(sizes[i], sizes[j]);
                EXPECT_GE(length(points[i] - points[j]), least * (1 - 1e-12));
            }
        }
    }
}

TEST(Poisson, PointsKeepAwayFromShellVertices) {
    const Shell shell = shapes::icosphere(1, 2);
    const shapes::ElementSize size(shell);
    const Result result = sample_count(shell, "auto");
    for (std::size_t i = result.points.shell_vertex_count; i < result.points.positions.size(); ++i) {
        const Vec3 p = result.points.positions[i];
        for (const Vec3 v : shell.positions) {
            EXPECT_GE(length(p - v), 0.7 * result.report.spacing * size.at(p) * (1 - 1e-12));
        }
    }
}

TEST(Poisson, SpacingIsMostOfWhatRandomPackingAllows) {
    // Darts of diameter r jam at 0.73 / r^3 a volume; twelve candidates a point get within a quarter of that radius.
    const Result result = sample_count(shapes::subdivided_box(12), "auto");
    ASSERT_GT(result.report.points, 400u);
    EXPECT_GT(result.report.spacing, 0.75 * std::cbrt(0.73 * 0.7));
}

TEST(Poisson, NearFinerShellPointsAreDenser) {
    const Result result = sample_count(graded_shell(), "600");
    int near = 0;
    int far = 0;
    for (std::size_t i = result.points.shell_vertex_count; i < result.points.positions.size(); ++i) {
        const double radius = length(result.points.positions[i]);
        near += radius < 0.5 ? 1 : 0;
        far += radius > 0.6 && radius < 0.75 ? 1 : 0;
    }
    // Both hold about the same volume: 0.5^3 less the inner sphere, and 0.75^3 - 0.6^3.
    EXPECT_GT(near, 2 * far);
}

TEST(Poisson, OnePointIsPossible) { EXPECT_EQ(sample_count(shapes::icosphere(1, 3), "1").report.points, 1u); }

}
