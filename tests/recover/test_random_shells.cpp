// SPDX-License-Identifier: GPL-3.0-or-later
// Rough balls, star-shaped and so free of self-intersections, with any number of points inside.
#include <gtest/gtest.h>

#include <cstdlib>

#include "hard_shells.h"
#include "recovered.h"

using namespace crumple;
using namespace crumple::recover;

namespace {

int seeds() { return std::getenv("CRUMPLE_FULL_TESTS") ? 200 : 12; }

TEST(RandomShells, RoughBallsComeBackWhole) {
    for (int seed = 0; seed < seeds(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Shell shell = shapes::rough_ball(1 + seed % 2, 0.1 + 0.2 * (seed % 4), 1, seed);
        const TetMesh before = delaunay_of(shell, std::to_string(10 * (seed % 5)));
        Params params;
        params.mode = Mode::always;
        const Result result = recover_shell(before, shell, params);
        expect_sound(shell, before, result.mesh);
        expect_no_crossing(shell, result.mesh);
        expect_whole(shell, result);
    }
}

TEST(RandomShells, AutoLosesNextToNothing) {
    for (int seed = 0; seed < seeds(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Shell shell = shapes::rough_ball(2, 0.8, 1, 100 + seed);
        const TetMesh before = delaunay_of(shell, "50");
        const Result result = recover_shell(before, shell);
        expect_sound(shell, before, result.mesh);
        EXPECT_EQ(result.report.missing_edges, result.report.negligible_edges);
        EXPECT_EQ(result.report.missing_triangles, result.report.negligible_triangles);
        const cull::Report culled = cull::cull_outside(shell, result.mesh).report;
        EXPECT_LT(culled.volume_error, 1e-3);
        EXPECT_LT(culled.hausdorff_out, 3e-3);
        EXPECT_LT(culled.hausdorff_in, 3e-3);
    }
}

}
