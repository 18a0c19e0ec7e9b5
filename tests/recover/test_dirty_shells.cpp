// SPDX-License-Identifier: GPL-3.0-or-later
// Shells that cannot be brought back whole: what can be is, the rest is named, and it ends.
#include <gtest/gtest.h>

#include <algorithm>

#include "hard_shells.h"
#include "recovered.h"

using namespace crumple;
using namespace crumple::recover;

namespace {

Result recovered(const Shell& shell, const std::string& count = "30", Mode mode = Mode::automatic) {
    const TetMesh before = delaunay_of(shell, count);
    Params params;
    params.mode = mode;
    Result result = recover_shell(before, shell, params);
    expect_sound(shell, before, result.mesh);
    const Report& report = result.report;
    EXPECT_GE(report.missing_edges, report.negligible_edges + report.blocked_edges);
    EXPECT_GE(report.missing_triangles, report.negligible_triangles + report.blocked_triangles);
    return result;
}

const Finding* find(const Report& report, const std::string& code) {
    for (const Finding& finding : report.findings) {
        if (finding.code == code) return &finding;
    }
    return nullptr;
}

TEST(DirtyShells, CrossingPartsAreNamedAndCostNoNodes) {
    const Shell a = shapes::torus(1, 0.4, 16, 8);
    const Shell shell = shapes::joined(a, shapes::moved(a, {0.5, 0.3, 0}));
    const Result result = recovered(shell);
    const Finding* blocked = find(result.report, "RECOVER_BLOCKED");
    ASSERT_NE(blocked, nullptr);
    EXPECT_EQ(blocked->count, result.report.blocked_edges + result.report.blocked_triangles);
    ASSERT_FALSE(blocked->places.empty());
    for (const auto& place : blocked->places) {
        EXPECT_NE(place.name.find(", crossed by triangle "), std::string::npos) << place.name;
    }
    EXPECT_LT(blocked->places[0].element, shell.triangles.size());
    EXPECT_EQ(result.report.steiner_points_tried, 0u);
    EXPECT_EQ(find(result.report, "RECOVER_STUCK"), nullptr);
}

TEST(DirtyShells, ASurfaceThroughItselfKeepsItsOtherParts) {
    Shell shell = shapes::icosphere(1, 2);
    shell.positions[0] = round_to_float(shell.positions[0] * -1.5);  // pulled through the other side
    const Result result = recovered(shell);
    EXPECT_GT(result.report.blocked_edges + result.report.blocked_triangles, 0u);
    EXPECT_LT(result.report.blocked_triangles, 60u);
}

TEST(DirtyShells, CopiesOfTrianglesAreOne) {
    Shell shell = shapes::twisted_prism();
    shell = shapes::joined(shell, shell);
    const Result result = recovered(shell, "0");
    EXPECT_EQ(result.report.triangles, 8u);
    EXPECT_EQ(result.report.missing_triangles, 0u);
}

TEST(DirtyShells, FlatTrianglesAndTJunctionsAreSplitAtTheNodesInThem) {
    // The middle of one side of the prism's bottom belongs to one triangle only: a triangle without area fills the gap.
    Shell shell = shapes::twisted_prism(6, 1, 0.4);
    const Triangle t = shell.triangles[0];
    const Index m = static_cast<Index>(shell.positions.size());
    shell.positions.push_back(round_to_float((shell.positions[t[0]] + shell.positions[t[1]]) * 0.5));
    shell.locked.push_back(0);
    shell.source_vertex.push_back(m);
    shell.triangles[0] = {t[0], m, t[2]};
    shell.triangles.push_back({m, t[1], t[2]});
    shell.triangles.push_back({t[0], t[1], m});
    shell.component.resize(shell.triangles.size(), 0);
    recovered(shell, "0");
    recovered(shell, "30", Mode::always);
}

TEST(DirtyShells, OpenShellsComeBackAsFarAsTheyGo) {
    const Shell shell = shapes::without_triangle(shapes::knot(2, 3, 0.35, 40, 5));
    const Result result = recovered(shell);
    EXPECT_EQ(result.report.missing_triangles, result.report.negligible_triangles);
}

TEST(DirtyShells, TouchingBoxesAreCoveredByFaces) {
    const Shell shell = shapes::joined(shapes::subdivided_box(3), shapes::subdivided_box(2, {1, 0, 0}, {2, 1, 1}));
    const Result result = recovered(shell);
    EXPECT_EQ(result.report.steiner_points, 0u);
}

TEST(DirtyShells, ASoupOfRandomTrianglesEnds) {
    Rng random(11);
    for (int round = 0; round < 2; ++round) {
        std::vector<Vec3> positions;
        for (int v = 0; v < 40; ++v) {
            const double x = random.next_below(8);
            const double y = random.next_below(8);
            const double z = random.next_unit();
            positions.push_back({x, y, z});
        }
        std::vector<Triangle> triangles;
        for (int f = 0; f < 80; ++f) {
            const Index a = random.next_below(40);
            const Index b = random.next_below(40);
            const Index c = random.next_below(40);
            if (a != b && b != c && c != a) triangles.push_back({a, b, c});
        }
        const Shell shell = shapes::solid_of(positions, triangles);
        const TetMesh before = delaunay::tetrahedralize(shapes::points_of(shell)).mesh;
        const Result result = recover_shell(before, shell);
        expect_sound(shell, before, result.mesh);
        EXPECT_GT(result.report.blocked_triangles, 0u);
    }
}

}
