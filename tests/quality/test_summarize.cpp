// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"
#include "mesh/shapes.h"
#include "quality/element_stiffness.h"
#include "quality/quality.h"

using namespace crumple;
using namespace crumple::quality;

namespace {

TEST(Summarize, NoTetsAreSummarizedAsZeros) {
    const Summary summary = summarize(TetMesh{});
    EXPECT_EQ(summary.tets, 0u);
    EXPECT_EQ(summary.nodes, 0u);
    EXPECT_EQ(summary.min_dihedral_deg, 0);
    EXPECT_EQ(summary.edge_ratio, 0);
    EXPECT_TRUE(worst_tets({}, {}).empty());
}

TEST(Summarize, ACubeOfSixTetsHasItsKnownMeasures) {
    const TetMesh mesh = shapes::tet_grid(1);
    const Summary summary = summarize(mesh);
    EXPECT_EQ(summary.tets, 6u);
    EXPECT_EQ(summary.nodes, 8u);
    EXPECT_EQ(summary.inverted, 0u);
    EXPECT_DOUBLE_EQ(summary.volume, 1);
    EXPECT_NEAR(summary.min_dihedral_deg, 45, 1e-9);
    EXPECT_NEAR(summary.median_dihedral_deg, 45, 1e-9);
    EXPECT_NEAR(summary.max_dihedral_deg, 90, 1e-9);
    EXPECT_EQ(summary.below_10_deg, 0u);
    EXPECT_NEAR(summary.edge_ratio, std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(summary.stiffness_ratio, 1, 1e-12);
}

TEST(Summarize, ARegularTetIsTheIdeal) {
    TetMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
    mesh.tets = {{0, 1, 2, 3}};
    const Summary summary = summarize(mesh);
    EXPECT_NEAR(summary.element_step_ratio, 1, 1e-12);
    EXPECT_NEAR(summary.radius_ratio_min, 1, 1e-12);
    EXPECT_NEAR(summary.volume_lrms3_min, 1, 1e-12);
    EXPECT_NEAR(summary.edge_ratio, 1, 1e-12);
}

TEST(Summarize, NodesThatNoTetUsesAreNotCounted) {
    TetMesh mesh = shapes::tet_grid(1);
    mesh.positions.push_back({9, 9, 9});
    EXPECT_EQ(summarize(mesh).nodes, 8u);
}

TEST(Summarize, InvertedTetsAreCounted) {
    TetMesh mesh = shapes::tet_grid(1);
    std::swap(mesh.tets[2][0], mesh.tets[2][1]);
    const Summary summary = summarize(mesh);
    EXPECT_EQ(summary.inverted, 1u);
    EXPECT_EQ(summary.min_dihedral_deg, 0);
    EXPECT_EQ(summary.element_step_m, 0);
}

// 100 tets, tet i with corners on a square and a height that grows with i.
TetMesh tets_of_growing_height() {
    TetMesh mesh;
    for (int i = 0; i < 100; ++i) {
        const auto first = static_cast<Index>(mesh.positions.size());
        const double x = 10.0 * i;
        const double height = (i + 1) * 0.005;
        mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, height}});
        mesh.tets.push_back({first, first + 1, first + 2, first + 3});
    }
    return mesh;
}

TEST(Summarize, PercentilesAreValuesOfTheRankedTets) {
    TetMesh mesh = tets_of_growing_height();
    const auto angle_of = [&](std::size_t t) {
        const auto& [a, b, c, d] = mesh.tets[t];
        return degrees_of(
            measure_tet(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]).min_dihedral);
    };
    const Summary summary = summarize(mesh);
    EXPECT_EQ(summary.min_dihedral_deg, angle_of(0));
    EXPECT_EQ(summary.p1_dihedral_deg, angle_of(0));
    EXPECT_EQ(summary.p5_dihedral_deg, angle_of(4));
    EXPECT_EQ(summary.median_dihedral_deg, angle_of(49));
    std::uint32_t below = 0;
    for (std::size_t t = 0; t < 100; ++t) below += angle_of(t) < 10 ? 1 : 0;
    EXPECT_EQ(summary.below_10_deg, below);
    EXPECT_GT(below, 0u);
    EXPECT_LT(below, 100u);
}

TEST(Summarize, TheOrderOfTetsDoesNotMatterButForTheSumOfVolumes) {
    TetMesh mesh = tets_of_growing_height();
    const Summary straight = summarize(mesh);
    std::reverse(mesh.tets.begin(), mesh.tets.end());
    const Summary reversed = summarize(mesh);
    EXPECT_EQ(straight.p5_dihedral_deg, reversed.p5_dihedral_deg);
    EXPECT_EQ(straight.radius_ratio_p5, reversed.radius_ratio_p5);
    EXPECT_EQ(straight.stiffness_ratio, reversed.stiffness_ratio);
    EXPECT_DOUBLE_EQ(straight.volume, reversed.volume);
}

TEST(Summarize, SameBytesForAnyNumberOfThreads) {
    const TetMesh mesh = shapes::tet_grid(8);
    Context four;
    four.jobs = 4;
    const Summary alone = summarize(mesh);
    const Summary together = summarize(mesh, four);
    EXPECT_EQ(alone.volume, together.volume);
    EXPECT_EQ(alone.p5_dihedral_deg, together.p5_dihedral_deg);
    EXPECT_EQ(alone.element_step_ratio, together.element_step_ratio);
}

TEST(Score, FewerFlatTetsWinThenTheFirstPercentile) {
    EXPECT_TRUE(is_better({3, 0.1, 0, 0}, {4, 0.9, 0, 0}));
    EXPECT_FALSE(is_better({4, 0.9, 0, 0}, {3, 0.1, 0, 0}));
    EXPECT_TRUE(is_better({3, 0.2, 0, 0}, {3, 0.1, 0.9, 0.9}));
    EXPECT_FALSE(is_better({3, 0.1, 0.2, 0.3}, {3, 0.1, 0.1, 0.1}));
}

TEST(Score, AgreesWithTheSummary) {
    const TetMesh mesh = tets_of_growing_height();
    const Score score = score_of(mesh.positions, mesh.tets);
    const Summary summary = summarize(mesh);
    EXPECT_EQ(score.below_10_deg, summary.below_10_deg);
    EXPECT_EQ(degrees_of(score.p1_dihedral), summary.p1_dihedral_deg);
    EXPECT_EQ(degrees_of(score.p5_dihedral), summary.p5_dihedral_deg);
    EXPECT_EQ(degrees_of(score.median_dihedral), summary.median_dihedral_deg);
}

TEST(WorstTets, ComeFlattestFirstWithTheirPlace) {
    const TetMesh mesh = tets_of_growing_height();
    const std::vector<Place> worst = worst_tets(mesh.positions, mesh.tets, 3);
    ASSERT_EQ(worst.size(), 3u);
    for (Index i = 0; i < 3; ++i) {
        EXPECT_EQ(worst[i].element, i);
        EXPECT_DOUBLE_EQ(worst[i].position.x, 10.0 * i + 0.25);
    }
    EXPECT_EQ(worst_tets(mesh.positions, mesh.tets, 1000).size(), 100u);
}

TEST(WorstTets, TiesAreOrderedByPlaceNotByIndex) {
    TetMesh mesh = shapes::tet_grid(2);
    const std::vector<Place> straight = worst_tets(mesh.positions, mesh.tets);
    std::reverse(mesh.tets.begin(), mesh.tets.end());
    const std::vector<Place> reversed = worst_tets(mesh.positions, mesh.tets);
    ASSERT_EQ(straight.size(), reversed.size());
    for (std::size_t i = 0; i < straight.size(); ++i) EXPECT_EQ(straight[i].position, reversed[i].position);
}

}
