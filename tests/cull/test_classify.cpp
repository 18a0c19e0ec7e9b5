// SPDX-License-Identifier: GPL-3.0-or-later
#include "cull/classify.h"

#include <gtest/gtest.h>

#include "mesh/shapes.h"

namespace crumple::cull {
namespace {

std::vector<Verdict> classify(const Shell& shell, const TetMesh& mesh, const Params& params = {}) {
    const ShellInterior interior(shell);
    return classify_tets(shell, interior, study_solid(shell, interior), mesh, params, {});
}

TEST(Classify, ThePatternIsInsideEvenAndTheSameForEveryCorner) {
    for (const std::uint32_t wanted : {1u, 8u, 20u, 21u}) {
        const auto pattern = sample_pattern(wanted);
        EXPECT_GE(pattern.size(), wanted);
        std::array<double, 4> sum{};
        for (const auto& weights : pattern) {
            for (int i = 0; i < 4; ++i) {
                EXPECT_GT(weights[i], 0);
                sum[i] += weights[i] / static_cast<double>(pattern.size());
            }
            EXPECT_NEAR(weights[0] + weights[1] + weights[2] + weights[3], 1, 1e-15);
        }
        for (const double s : sum) EXPECT_NEAR(s, 0.25, 1e-12);
    }
    EXPECT_EQ(sample_pattern(20).size(), 20u);
    EXPECT_EQ(sample_pattern(21).size(), 35u);
}

TEST(Classify, TheInnermostComponentNamesTheRegion) {
    const TetMesh grid = shapes::tet_grid(3, {0, 0, 0}, {3, 3, 3});
    const auto verdicts = classify(shapes::nested_boxes(Role::rigid), grid);
    int inner = 0;
    for (const Verdict& verdict : verdicts) {
        EXPECT_FALSE(verdict.straddles);
        inner += verdict.region == 1;
    }
    EXPECT_EQ(inner, 6);  // the middle cube
    const auto around_cavity = classify(shapes::nested_boxes(Role::cavity), grid);
    EXPECT_EQ(
        std::count_if(around_cavity.begin(), around_cavity.end(), [](const Verdict& v) { return v.region == none; }),
        6);
}

TEST(Classify, TheMajorityOfATetDecides) {
    // One cube of six tets, of which the shell holds the lower part.
    const TetMesh cube = shapes::tet_grid(1);
    for (const double height : {0.05, 0.95}) {
        const auto verdicts = classify(shapes::box({-1, -1, -1}, {2, height, 2}), cube);
        for (const Verdict& verdict : verdicts) {
            EXPECT_TRUE(verdict.straddles);
            EXPECT_EQ(verdict.region == none, height < 0.5);
        }
    }
}

TEST(Classify, MinInsideMovesTheLimit) {
    const TetMesh cube = shapes::tet_grid(1);
    const Shell lower = shapes::box({-1, -1, -1}, {2, 0.3, 2});
    const auto count = [&](double min_inside) {
        Params params;
        params.min_inside = min_inside;
        const auto verdicts = classify(lower, cube, params);
        return std::count_if(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.region != none; });
    };
    EXPECT_EQ(count(0), 6);
    EXPECT_EQ(count(0.95), 0);
    EXPECT_LE(count(0.5), count(0.2));
}

}
}
