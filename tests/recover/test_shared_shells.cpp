// SPDX-License-Identifier: GPL-3.0-or-later
// Real shells through sample, delaunay, relax, recover and cull.
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/surface_distance.h"
#include "recovered.h"
#include "relax/relax.h"
#include "sample/read_obj_shell.h"

using namespace crumple;
using namespace crumple::recover;

namespace {

struct Expected {
    const char* path;
    double volume_error;  // share
    double hausdorff;     // of the diagonal
    bool is_clean;        // no part crosses another
};

class Shared : public testing::TestWithParam<Expected> {};

TEST_P(Shared, LosesNoShape) {
    CRUMPLE_NEEDS_DATA();
    const auto shell = shapes::read_obj_shell(test::data_folder() / GetParam().path);
    ASSERT_TRUE(shell);
    const TetMesh before = relax::relax_points(delaunay_of(*shell, "auto"), *shell).mesh;
    const Result result = recover_shell(before, *shell);
    expect_sound(*shell, before, result.mesh);
    const cull::Report culled = cull::cull_outside(*shell, result.mesh).report;
    EXPECT_LE(culled.volume_error, GetParam().volume_error);
    EXPECT_LE(culled.hausdorff_out, GetParam().hausdorff);
    EXPECT_LE(culled.hausdorff_in, GetParam().hausdorff);
    EXPECT_LE(static_cast<double>(result.report.steiner_points), 0.1 * static_cast<double>(shell->positions.size()));
    if (!GetParam().is_clean) return;
    EXPECT_EQ(result.report.missing_edges, result.report.negligible_edges);
    EXPECT_EQ(result.report.missing_triangles, result.report.negligible_triangles);
    EXPECT_EQ(result.report.steiner_points, 0u);
}

// The car body lost 8.4 % of its volume and had 21 non-manifold edges before there was this stage.
TEST(SharedShells, TheCarBodyIsExactAndManifold) {
    CRUMPLE_NEEDS_DATA();
    const auto shell = shapes::read_obj_shell(test::data_folder() / "quality/carbody.obj");
    ASSERT_TRUE(shell);
    const TetMesh before = relax::relax_points(delaunay_of(*shell, "auto"), *shell).mesh;
    const Result result = recover_shell(before, *shell);
    EXPECT_EQ(result.report.added_nodes, 0u);
    const cull::Report culled = cull::cull_outside(*shell, result.mesh).report;
    EXPECT_LT(culled.volume_error, 1e-6);
    EXPECT_EQ(culled.non_manifold_edges, 0u);
    EXPECT_EQ(culled.non_manifold_vertices, 0u);
    EXPECT_EQ(culled.straddling, 0u);
}

TEST(SharedShells, NodesPutOnTheShellAreTold) {
    CRUMPLE_NEEDS_DATA();
    const auto shell = shapes::read_obj_shell(test::data_folder() / "quality/suzanne.obj");
    ASSERT_TRUE(shell);
    const TetMesh before = relax::relax_points(delaunay_of(*shell, "auto"), *shell).mesh;
    const Report report = recover_shell(before, *shell).report;
    ASSERT_GT(report.steiner_points, 0u);
    const auto told = std::find_if(report.findings.begin(), report.findings.end(),
                                   [](const Finding& finding) { return finding.code == "RECOVER_STEINER"; });
    ASSERT_NE(told, report.findings.end());
    EXPECT_EQ(told->count, report.steiner_points);
    EXPECT_EQ(told->places.size(), std::min<std::size_t>(report.steiner_points, max_places));
    const SurfaceDistance surface(shell->positions, shell->triangles);
    for (const Place& place : told->places) EXPECT_LT(surface.closest(place.position).distance, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(
    Shells, Shared,
    testing::Values(Expected{"quality/carhood.obj", 1e-6, 1e-6, true}, Expected{"quality/bonnet.obj", 1e-6, 1e-6, true},
                    Expected{"quality/boxnest.obj", 1e-6, 1e-6, true}, Expected{"quality/spot.obj", 1e-3, 3e-3, true},
                    Expected{"quality/fandisk.obj", 1e-3, 3e-3, true}, Expected{"quality/cow.obj", 3e-3, 1e-2, false},
                    Expected{"open/suv_authored_collision.obj", 1e-3, 3e-3, true}),
    [](const auto& parameter) {
        std::string name = parameter.param.path;
        std::replace_if(
            name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
        return name;
    });

}
