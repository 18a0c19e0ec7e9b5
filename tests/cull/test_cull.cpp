// SPDX-License-Identifier: GPL-3.0-or-later
#include "cull/cull.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "delaunay/delaunay.h"
#include "geometry/predicates.h"
#include "mesh/shapes.h"
#include "mesh/validate.h"

namespace crumple::cull {
namespace {

// Delaunay tets of the shell's vertices and of the interior points given.
TetMesh tets_of(const Shell& shell, std::vector<Vec3> interior = {}) {
    PointSet points = shapes::points_of(shell);
    points.positions.insert(points.positions.end(), interior.begin(), interior.end());
    return delaunay::tetrahedralize(points).mesh;
}

Result cull(const Shell& shell, std::vector<Vec3> interior = {}, const Params& params = {},
            const Context& context = {}) {
    return cull_outside(shell, tets_of(shell, std::move(interior)), params, context);
}

bool has(const Report& report, const std::string& code) {
    return std::any_of(report.findings.begin(), report.findings.end(),
                       [&](const Finding& f) { return f.code == code; });
}

// A U of three bars standing in the plane z in [0, 1]: its hull holds the gap between the legs.
Shell staple() {
    Shell shell = shapes::subdivided_box(4, {0, 0, 0}, {4, 4, 1});
    std::vector<Vec3> positions;
    // Push the middle of the top down between the legs.
    for (Vec3& p : shell.positions) {
        if (p.y == 4 && p.x == 2) p.y = 1;
    }
    return shell;
}

TEST(Cull, NoShellOrNoTetsIsRefused) {
    EXPECT_THROW((void)cull_outside(Shell{}, TetMesh{}), Error);
    TetMesh mesh = shapes::tet_grid(1);
    EXPECT_THROW((void)cull_outside(Shell{}, mesh), Error);
}

TEST(Cull, NothingLeftSaysWhatToTry) {
    Shell shell = shapes::box();
    shell.components[0].role = Role::cavity;
    try {
        (void)cull(shell);
        FAIL() << "nothing is left, and nobody says so";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        EXPECT_NE(std::string(error.what()).find("cavit"), std::string::npos);
    }
    Shell sheet = shapes::subdivided_box(3, {0, 0, 0}, {1, 1, 1});
    std::erase_if(sheet.triangles, [&](const Triangle& t) {
        return std::any_of(t.begin(), t.end(), [&](Index v) { return sheet.positions[v].y > 0; });
    });
    sheet.component.resize(sheet.triangles.size());
    EXPECT_THROW((void)cull(sheet), Error);
}

TEST(Cull, AMeshThatIsNotTheShellsIsABug) {
    TetMesh mesh = tets_of(shapes::box());
    mesh.positions[0].x = 7;
    EXPECT_THROW((void)cull_outside(shapes::box(), mesh), Error);
    mesh = tets_of(shapes::box());
    std::swap(mesh.tets[0][0], mesh.tets[0][1]);
    EXPECT_THROW((void)cull_outside(shapes::box(), mesh), Error);
}

TEST(Cull, AConvexShellKeepsEverything) {
    const Result result = cull(shapes::icosphere(1, 2), {{0, 0, 0}, {0.25, 0.25, 0}, {0, -0.5, 0.25}});
    EXPECT_EQ(result.report.kept, result.report.tets);
    EXPECT_EQ(result.report.dropped_nodes, 0u);
    EXPECT_TRUE(result.report.shell_volume_is_exact);
    EXPECT_LT(result.report.volume_error, 1e-12);
    EXPECT_LT(result.report.hausdorff_out, 1e-6);
    EXPECT_LT(result.report.hausdorff_in, 1e-6);
    EXPECT_EQ(result.report.pieces, 1u);
    EXPECT_EQ(result.report.non_manifold_edges + result.report.non_manifold_vertices, 0u);
    EXPECT_TRUE(result.report.findings.empty());
    EXPECT_TRUE(validate(result.mesh, 1).empty());
}

TEST(Cull, WhatLiesOutsideGoesAndUnusedInteriorNodesWithIt) {
    const Shell shell = shapes::torus(1, 0.4, 24, 10);
    // Points in the hole are nodes of tets outside only.
    const Result result = cull(shell, {{0, 0, 0}, {1, 0, 0}, {0.125, 0, 0.125}, {-1, 0, 0}});
    EXPECT_EQ(result.report.dropped_nodes, 2u);
    ASSERT_EQ(result.mesh.positions.size(), shell.positions.size() + 2);
    EXPECT_EQ(result.mesh.positions[shell.positions.size()], (Vec3{1, 0, 0}));
    EXPECT_EQ(result.mesh.positions.back(), (Vec3{-1, 0, 0}));
    EXPECT_LT(result.report.kept, result.report.tets);
    EXPECT_LT(result.report.volume_error, 0.01);
    EXPECT_EQ(result.report.non_manifold_edges, 0u);
    EXPECT_TRUE(validate(result.mesh, 1).empty());
}

TEST(Cull, KeepsShellPointsAtTheirIndexAndTheOrderOfTets) {
    const Shell shell = shapes::torus(1, 0.4, 16, 8);
    const TetMesh before = tets_of(shell);
    const Result result = cull_outside(shell, before);
    ASSERT_GE(result.mesh.positions.size(), shell.positions.size());
    EXPECT_TRUE(std::equal(shell.positions.begin(), shell.positions.end(), result.mesh.positions.begin()));
    EXPECT_EQ(result.mesh.shell_vertex_count, shell.positions.size());
    auto from = before.tets.begin();
    for (const Tet& tet : result.mesh.tets) {
        from = std::find(from, before.tets.end(), tet);
        ASSERT_NE(from, before.tets.end());
    }
}

TEST(Cull, RolesAreHonoured) {
    const Result hollow = cull(shapes::nested_boxes(Role::cavity));
    EXPECT_NEAR(hollow.report.volume, 26, 1e-12);
    EXPECT_LT(hollow.report.volume_error, 1e-12);
    EXPECT_LT(hollow.report.hausdorff_in, 1e-12);
    EXPECT_EQ(hollow.report.regions[1].tets, 0u);
    EXPECT_FALSE(has(hollow.report, "CULL_COMPONENT_WITHOUT_TETS"));

    const Result engine = cull(shapes::nested_boxes(Role::rigid));
    EXPECT_NEAR(engine.report.volume, 27, 1e-12);
    EXPECT_NEAR(engine.report.regions[1].volume, 1, 1e-12);
    EXPECT_EQ(engine.report.regions[1].role, Role::rigid);
    // The inner shell lies in material on both sides: the tets' surface need not follow it.
    EXPECT_LT(engine.report.hausdorff_in, 1e-12);
    EXPECT_EQ(engine.report.pieces, 1u);
    EXPECT_EQ(engine.report.shell_pieces, 1u);
}

TEST(Cull, CrossingShellsAreTheirUnionAndTheReportSaysItIsEstimated) {
    const Shell shell = shapes::joined(shapes::subdivided_box(3, {0, 0, 0}, {3, 3, 3}),
                                       shapes::subdivided_box(3, {2, 2, 2}, {5, 5, 5}));
    const Result result = cull(shell);
    EXPECT_FALSE(result.report.shell_volume_is_exact);
    EXPECT_TRUE(has(result.report, "CULL_VOLUME_ESTIMATED"));
    EXPECT_NEAR(result.report.shell_volume, 53, 0.53);
}

TEST(Cull, AnOpenShellIsDecidedByItsWindingNumberAndNamed) {
    const Result result = cull(shapes::without_triangle(shapes::icosphere(1, 3)));
    EXPECT_TRUE(has(result.report, "CULL_OPEN_SHELL"));
    EXPECT_LT(result.report.leak_share, 0.02);
    EXPECT_NEAR(result.report.volume, 4.15, 0.1);

    Shell half = shapes::icosphere(1, 3);
    std::erase_if(half.triangles, [&](const Triangle& t) { return half.positions[t[0]].y > 0.1; });
    half.component.resize(half.triangles.size());
    const Result leaking = cull(half);
    EXPECT_GT(leaking.report.leak_share, 0.02);
    EXPECT_TRUE(has(leaking.report, "CULL_LEAK"));
}

TEST(Cull, ShellVerticesLeftUnusedAreNamed) {
    Shell shell = shapes::joined(shapes::box({0, 0, 0}, {4, 4, 4}), shapes::tetrahedron(0.25));
    for (Vec3& p : shell.positions) p = p + Vec3{1, 1, 1};
    // A flat sliver of a part outside the box: no tet of the Delaunay complex lies in it for the most part.
    for (Index v = 8; v < 12; ++v) shell.positions[v] = shell.positions[v] + Vec3{7, 0, 0};
    shell.locked[9] = 1;
    TetMesh mesh = tets_of(shell);
    std::erase_if(mesh.tets,
                  [](const Tet& t) { return std::all_of(t.begin(), t.end(), [](Index v) { return v >= 8; }); });
    const Result result = cull_outside(shell, mesh);
    EXPECT_EQ(result.report.unused_shell_vertices, 4u);
    ASSERT_TRUE(has(result.report, "CULL_UNUSED_SHELL_VERTICES"));
    EXPECT_TRUE(has(result.report, "CULL_COMPONENT_WITHOUT_TETS"));
    for (const Finding& finding : result.report.findings) {
        if (finding.code != "CULL_UNUSED_SHELL_VERTICES") continue;
        EXPECT_EQ(finding.count, 4u);
        EXPECT_EQ(finding.places[0].element, 8u);
        EXPECT_EQ(finding.places[0].name, "tetrahedron");
        EXPECT_EQ(finding.places[0].position, shell.positions[8]);
        EXPECT_NE(finding.message.find("1 of them locked"), std::string::npos);
    }
    EXPECT_EQ(result.report.regions[1].unused_vertices, 4u);
    EXPECT_EQ(result.mesh.positions.size(), 12u);
}

TEST(Cull, PiecesThatTouchInAnEdgeAreCountedAndNamed) {
    // Two boxes that share an edge, in one component.
    Shell shell = shapes::joined(shapes::box({0, 0, 0}, {1, 1, 1}), shapes::box({1, 1, 0}, {2, 2, 1}));
    const Result result = cull(shell);
    EXPECT_EQ(result.report.pieces, 2u);
    EXPECT_FALSE(result.report.shell_volume_is_exact);
}

TEST(Cull, AConcaveShellIsMeasured) {
    const Shell shell = staple();
    const Result result = cull(shell);
    EXPECT_GT(result.report.tets, result.report.kept);
    EXPECT_LT(result.report.volume_error, 0.1);
    EXPECT_TRUE(validate(result.mesh, 1).empty());
}

TEST(Cull, ScaleAndPlaceDoNotMatter) {
    const Shell torus = shapes::torus(1, 0.4, 16, 8);
    const Result plain = cull(torus);
    for (const double scale : {0x1p-20, 0x1p14}) {
        const Result scaled = cull(shapes::moved(torus, {}, scale));
        EXPECT_EQ(scaled.mesh.tets, plain.mesh.tets);
        EXPECT_DOUBLE_EQ(scaled.report.volume_error, plain.report.volume_error);
        EXPECT_DOUBLE_EQ(scaled.report.hausdorff_in, plain.report.hausdorff_in);
    }
}

TEST(Cull, ThreadsDoNotChangeIt) {
    const Shell shell = shapes::joined(shapes::torus(1, 0.4, 24, 12), shapes::icosphere(0.8, 3, {1, 0.3, 0}));
    Context four;
    four.jobs = 4;
    const Result a = cull(shell);
    const Result b = cull(shell, {}, {}, four);
    EXPECT_EQ(a.mesh.tets, b.mesh.tets);
    EXPECT_EQ(a.mesh.region, b.mesh.region);
    EXPECT_EQ(a.report.shell_volume, b.report.shell_volume);
    EXPECT_EQ(a.report.hausdorff_in, b.report.hausdorff_in);
}

}
}
