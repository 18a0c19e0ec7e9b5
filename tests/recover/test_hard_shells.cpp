// SPDX-License-Identifier: GPL-3.0-or-later
// Shells that Delaunay misses, one by one: all of each comes back, without and with nodes inside.
#include <gtest/gtest.h>

#include <functional>

#include "hard_shells.h"
#include "recovered.h"

using namespace crumple;
using namespace crumple::recover;

namespace {

struct Case {
    const char* name;
    std::function<Shell()> shell;
};

class Hard : public testing::TestWithParam<Case> {
protected:
    void expect_recovered(const std::string& count) {
        const Shell shell = GetParam().shell();
        const TetMesh before = delaunay_of(shell, count);
        Params params;
        params.mode = Mode::always;
        const Result result = recover_shell(before, shell, params);
        expect_sound(shell, before, result.mesh);
        expect_no_crossing(shell, result.mesh);
        expect_whole(shell, result);
    }
};

TEST_P(Hard, ComesBackWholeWithoutInteriorPoints) { expect_recovered("0"); }
TEST_P(Hard, ComesBackWholeAroundInteriorPoints) { expect_recovered("40"); }

INSTANTIATE_TEST_SUITE_P(Shells, Hard,
                         testing::Values(Case{"Schoenhardt", [] { return shapes::twisted_prism(); }},
                                         Case{"SchoenhardtNearlyClosed",
                                              [] { return shapes::twisted_prism(3, 1, 0.87); }},
                                         Case{"TowerOfSchoenhardts", [] { return shapes::twisted_prism(3, 5); }},
                                         Case{"TwistedSquare", [] { return shapes::twisted_prism(4, 1, 0.7); }},
                                         Case{"TwistedHexagons", [] { return shapes::twisted_prism(6, 3, 0.5); }},
                                         Case{"TwistedDisc", [] { return shapes::twisted_prism(12, 1, 0.9, 0.5); }},
                                         Case{"SaddlePlate", [] { return shapes::saddle_plate(6, 0.05); }},
                                         Case{"ThinSaddlePlate", [] { return shapes::saddle_plate(10, 0.004); }},
                                         Case{"Spikes", [] { return shapes::spiked_ball(2, 3, 2.5); }},
                                         Case{"LongSpikes", [] { return shapes::spiked_ball(2, 2, 6); }},
                                         Case{"Trefoil", [] { return shapes::knot(); }},
                                         Case{"FatTrefoil", [] { return shapes::knot(2, 3, 0.6); }},
                                         Case{"LinkedRings", [] { return shapes::linked_rings(0.05); }},
                                         Case{"LinkedRingsAlmostTouching", [] { return shapes::linked_rings(0.005); }},
                                         Case{"ThinPlate", [] { return shapes::thin_plate(0.0005, 8); }},
                                         Case{"NestedBoxes", [] { return shapes::nested_boxes(); }},
                                         Case{"CosphericalGrid", [] { return shapes::subdivided_box(4); }}),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

TEST(Schoenhardt, NeedsOneNodeAndItEndsInside) {
    const Shell shell = shapes::twisted_prism();
    const Result result = recover_shell(delaunay_of(shell), shell);
    EXPECT_GT(result.report.missing_edges_before, 0u);
    EXPECT_EQ(result.report.steiner_points_tried, 1u);
    EXPECT_EQ(result.report.steiner_points, 0u);
    ASSERT_GE(result.report.added_nodes, 1u);
    const TetMesh kept = cull::cull_outside(shell, result.mesh).mesh;
    EXPECT_EQ(kept.positions.size(), 7u);
    // Strictly inside: it sees every triangle from behind.
    for (const Triangle& t : shell.triangles) {
        EXPECT_LT(orient3d(shell.positions[t[0]], shell.positions[t[1]], shell.positions[t[2]], kept.positions[6]), 0);
    }
}

TEST(Schoenhardt, WithoutAllowanceItIsSaidWhatIsMissing) {
    const Shell shell = shapes::twisted_prism();
    const TetMesh before = delaunay_of(shell);
    Params params;
    params.max_steiner = 0;
    const Result result = recover_shell(before, shell, params);
    expect_sound(shell, before, result.mesh);
    EXPECT_EQ(result.report.added_nodes, 0u);
    EXPECT_GT(result.report.missing_edges, 0u);
    ASSERT_EQ(result.report.findings.size(), 1u);
    EXPECT_EQ(result.report.findings[0].code, "RECOVER_STUCK");
    EXPECT_FALSE(result.report.findings[0].places.empty());
}

}
