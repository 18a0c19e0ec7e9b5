// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/clean.h"

#include "importer/components.h"
#include "importer/import_checks.h"
#include "importer/make_surface.h"
#include "mesh/shapes.h"

namespace crumple::importer {
namespace {

using test::find;
using test::surface_of;
using test::weld_unpainted;

struct CleanedSurface {
    Welded shell;
    Cleaned report;
    Components components;
};

CleanedSurface clean_surface(const Surface& surface) {
    CleanedSurface result;
    result.shell = weld_unpainted(surface);
    result.report = clean(surface, result.shell);
    result.components = split_components(surface, result.shell);
    return result;
}

Surface box_and(std::vector<Triangle> more) {
    Shell shell = shapes::box();
    shell.triangles.insert(shell.triangles.end(), more.begin(), more.end());
    return surface_of(shell);
}

TEST(Clean, ACleanBoxStays) {
    const auto result = clean_surface(box_and({}));
    EXPECT_EQ(result.shell.triangles, shapes::box().triangles);
    EXPECT_TRUE(result.report.findings.empty());
}

TEST(Clean, RepeatedIndicesGo) {
    const auto result = clean_surface(box_and({{0, 0, 1}, {2, 2, 2}}));
    EXPECT_EQ(result.report.repeated_index, 2u);
    EXPECT_EQ(result.shell.triangles.size(), 12u);
}

TEST(Clean, SecondCopiesGoWhicheverCornerTheyStartAt) {
    const Triangle t = shapes::box().triangles[3];
    const auto result = clean_surface(box_and({{t[1], t[2], t[0]}, t}));
    EXPECT_EQ(result.report.duplicates, 2u);
    EXPECT_EQ(result.shell.triangles, shapes::box().triangles);
    EXPECT_EQ(find(result.report.findings, "SHELL_DUPLICATE")->count, 2u);
}

TEST(Clean, BackToBackIsNotADuplicate) {
    const Triangle t = shapes::box().triangles[3];
    EXPECT_EQ(clean_surface(box_and({{t[0], t[2], t[1]}})).report.duplicates, 0u);
}

// A side of a tetrahedron cut at its middle on one side only: the needle between is topology, not area.
TEST(Clean, ANeedleOnAnEdgeIsMergedWithoutAHole) {
    const std::vector<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}};
    const std::vector<Triangle> triangles = {{0, 4, 3}, {4, 1, 3}, {0, 1, 4}, {1, 0, 2}, {1, 2, 3}, {0, 3, 2}};
    const auto result = clean_surface(surface_of(positions, triangles));
    EXPECT_EQ(result.report.zero_area, 1u);
    EXPECT_EQ(result.shell.triangles.size(), 6u);
    EXPECT_EQ(result.components.open_edges, 0u);
    EXPECT_TRUE(result.components.facts.at(0).is_closed);
    EXPECT_DOUBLE_EQ(std::abs(result.components.facts[0].signed_volume), 1.0 / 6);
    EXPECT_EQ(clean_surface(surface_of(result.shell.positions, result.shell.triangles)).report.zero_area, 0u);
}

TEST(Clean, NeedlesSideBySideAreAllMerged) {
    const std::vector<Vec3> positions = {{0, 0, 0},    {1, 0, 0},   {0, 1, 0},   {0, 0, 1},
                                         {0.25, 0, 0}, {0.5, 0, 0}, {0.75, 0, 0}};
    const std::vector<Triangle> triangles = {{0, 4, 3}, {4, 5, 3}, {5, 6, 3}, {6, 1, 3}, {0, 1, 6},
                                             {0, 6, 5}, {0, 5, 4}, {1, 0, 2}, {1, 2, 3}, {0, 3, 2}};
    const auto result = clean_surface(surface_of(positions, triangles));
    EXPECT_EQ(result.report.zero_area, 3u);
    EXPECT_EQ(result.components.open_edges, 0u);
    EXPECT_DOUBLE_EQ(std::abs(result.components.facts[0].signed_volume), 1.0 / 6);
    EXPECT_EQ(clean_surface(surface_of(result.shell.positions, result.shell.triangles)).report.zero_area, 0u);
}

TEST(Clean, ALooseNeedleGoes) {
    Shell shell = shapes::box();
    shell.positions.insert(shell.positions.end(), {{5, 0, 0}, {6, 0, 0}, {7, 0, 0}});
    shell.triangles.push_back({8, 9, 10});
    const auto result = clean_surface(surface_of(shell));
    EXPECT_EQ(result.report.zero_area, 1u);
    EXPECT_EQ(result.shell.triangles.size(), 12u);
    EXPECT_EQ(result.shell.positions.size(), 8u);
}

TEST(Clean, VerticesNobodyUsesGoAndTheirLocksAreReported) {
    Surface surface = box_and({});
    surface.positions.insert(surface.positions.begin(), Vec3{9, 9, 9});
    for (Triangle& t : surface.triangles) t = {t[0] + 1, t[1] + 1, t[2] + 1};
    surface.source_vertex.push_back(8);
    surface.vertex_part.push_back(0);
    PaintedVertices painted = test::unpainted(surface);
    painted.paint[0] = Paint::locked;
    painted.paint[8] = Paint::locked;
    Welded welded = weld(surface, painted, 1e-6);
    const Cleaned cleaned = clean(surface, welded);
    EXPECT_EQ(welded.positions.size(), 8u);
    EXPECT_EQ(cleaned.unused_locks, 1u);
    EXPECT_NE(find(cleaned.findings, "LOCK_UNUSED"), nullptr);
    EXPECT_EQ(welded.source_vertex.front(), 1u);
    EXPECT_EQ(welded.locked.back(), 1);
    EXPECT_EQ(welded.triangles, shapes::box().triangles);
}

}
}
