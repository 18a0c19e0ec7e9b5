// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "mesh/shapes.h"
#include "sample/sample.h"

using namespace crumple;
using namespace crumple::sample;

namespace {

Shell painted(Shell shell, float left, float right) {
    shell.color.clear();
    for (const Vec3 p : shell.positions) shell.color.push_back({1, p.x < 2 ? left : right, 1, 1});
    return shell;
}

const Shell& long_box() {
    static const Shell shell = shapes::subdivided_box(10, {0, 0, 0}, {4, 1, 1});
    return shell;
}

Result sample_painted(const Shell& shell, Method method = Method::poisson, std::string count = "auto") {
    Params params;
    params.painted_density = true;
    params.method = method;
    params.points = std::move(count);
    return sample_interior(shell, params);
}

TEST(PaintedDensity, WithoutColoursIsAFindingAndPlainSampling) {
    const Result plain = sample_interior(long_box());
    const Result asked = sample_painted(long_box());
    EXPECT_EQ(plain.points.positions, asked.points.positions);
    ASSERT_EQ(asked.report.findings.size(), 1u);
    EXPECT_EQ(asked.report.findings[0].code, "SAMPLE_NO_DENSITY");
}

TEST(PaintedDensity, IsIgnoredUnlessAskedFor) {
    EXPECT_EQ(sample_interior(painted(long_box(), 0, 1)).points.positions,
              sample_interior(long_box()).points.positions);
}

TEST(PaintedDensity, HalfGreenChangesNothing) {
    EXPECT_EQ(sample_painted(painted(long_box(), 0.5f, 0.5f)).points.positions,
              sample_interior(long_box()).points.positions);
}

TEST(PaintedDensity, FullGreenIsEightTimesAsDense) {
    const auto plain = static_cast<double>(sample_interior(long_box()).report.automatic_count);
    const auto dense = static_cast<double>(sample_painted(painted(long_box(), 1, 1)).report.automatic_count);
    // Eight times at the shell. Inside, sizes grow by 0.3 as ever, so less; but points may come nearer to the shell.
    EXPECT_GT(dense, 4 * plain);
    EXPECT_LT(dense, 16 * plain);
}

TEST(PaintedDensity, BlackGreenIsSparser) {
    const auto plain = sample_interior(long_box()).report.automatic_count;
    const auto sparse = sample_painted(painted(long_box(), 0, 0)).report.automatic_count;
    EXPECT_LT(4 * sparse, plain);
}

TEST(PaintedDensity, PointsGatherWhereItIsPainted) {
    for (const Method method : {Method::poisson, Method::uniform}) {
        const Result result = sample_painted(painted(long_box(), 0.25f, 0.75f), method, "600");
        ASSERT_EQ(result.report.points, 600u);
        const auto first = result.points.positions.begin() + result.points.shell_vertex_count;
        const auto right = std::count_if(first, result.points.positions.end(), [](Vec3 p) { return p.x > 2; });
        // Eight times the density near the right half of the shell; it fades into the left over two elements.
        EXPECT_GT(right, 400);
    }
}

TEST(PaintedDensity, WildColoursAreClamped) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(sample_painted(painted(long_box(), nan, nan)).points.positions,
              sample_painted(painted(long_box(), 0.5f, 0.5f)).points.positions);
    EXPECT_EQ(sample_painted(painted(long_box(), 7, 7)).points.positions,
              sample_painted(painted(long_box(), 1, 1)).points.positions);
    EXPECT_EQ(sample_painted(painted(long_box(), -7, -7)).points.positions,
              sample_painted(painted(long_box(), 0, 0)).points.positions);
}

}
