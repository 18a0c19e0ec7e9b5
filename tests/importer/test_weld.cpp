// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/weld.h"

#include "importer/import_checks.h"
#include "importer/make_surface.h"
#include "mesh/shapes.h"

namespace crumple::importer {
namespace {

using test::split_corners;
using test::surface_of;
using test::weld_unpainted;

PaintedVertices paint_all(const Surface& surface, Paint paint) {
    PaintedVertices painted;
    painted.paint.assign(surface.positions.size(), paint);
    return painted;
}

TEST(Weld, NothingStaysNothing) { EXPECT_TRUE(weld_unpainted(Surface{}).positions.empty()); }

TEST(Weld, CornersOfOnePositionBecomeOneVertexInFileOrder) {
    const Shell shell = shapes::icosphere(1, 2);
    const Surface surface = split_corners(surface_of(shell));
    const Welded welded = weld_unpainted(surface);
    EXPECT_EQ(welded.positions.size(), shell.positions.size());
    EXPECT_EQ(welded.exact_merges, surface.positions.size() - shell.positions.size());
    EXPECT_EQ(welded.tolerance_merges, 0u);
    for (std::size_t v = 1; v < welded.source_vertex.size(); ++v)
        EXPECT_LT(welded.source_vertex[v - 1], welded.source_vertex[v]);
    for (std::size_t v = 0; v < welded.positions.size(); ++v) {
        EXPECT_EQ(welded.positions[v], surface.positions[welded.source_vertex[v]]);
    }
}

TEST(Weld, AVertexListGivesTheOrder) {
    Surface surface = split_corners(surface_of(shapes::tetrahedron()));
    const Shell shell = shapes::tetrahedron();
    surface.has_vertex_list = true;
    for (std::size_t c = 0; c < surface.positions.size(); ++c) surface.source_vertex[c] = shell.triangles[c / 3][c % 3];
    const Welded welded = weld_unpainted(surface);
    EXPECT_EQ(welded.source_vertex, (std::vector<Index>{0, 1, 2, 3}));
    EXPECT_EQ(welded.positions, shell.positions);
}

TEST(Weld, AnyLockedCopyLocksAndDisagreementCounts) {
    const Surface surface = split_corners(surface_of(shapes::tetrahedron()));
    PaintedVertices painted = paint_all(surface, Paint::free);
    painted.paint[5] = Paint::locked;
    const Welded welded = weld(surface, painted, 1e-6);
    EXPECT_EQ(std::count(welded.locked.begin(), welded.locked.end(), 1), 1);
    EXPECT_EQ(welded.conflicts.count, 1u);
    EXPECT_EQ(welded.conflicts.places.at(0).position, surface.positions[5]);
}

TEST(Weld, AnUncolouredCopyIsNoDisagreement) {
    const Surface surface = split_corners(surface_of(shapes::tetrahedron()));
    PaintedVertices painted = paint_all(surface, Paint::none);
    painted.paint[5] = Paint::locked;
    EXPECT_EQ(weld(surface, painted, 1e-6).conflicts.count, 0u);
}

// Two boxes a hair apart: closed, so the hair stays.
TEST(Weld, ToleranceLeavesClosedSurfacesAlone) {
    const Shell pair = shapes::joined(shapes::box(), shapes::box({1.0000002f, 0, 0}, {2, 1, 1}));
    const Welded welded = weld_unpainted(surface_of(pair));
    EXPECT_EQ(welded.positions.size(), 16u);
    EXPECT_EQ(welded.tolerance_merges, 0u);
}

Surface box_with_crack(double width) {
    Surface surface = split_corners(surface_of(shapes::box()));
    for (std::size_t c = 0; c < 9; ++c) surface.positions[c] = round_to_float(surface.positions[c] + Vec3{width, 0, 0});
    return surface;
}

TEST(Weld, ToleranceClosesCracks) {
    const Welded welded = weld_unpainted(box_with_crack(1e-6));
    EXPECT_EQ(welded.positions.size(), 8u);
    EXPECT_GT(welded.tolerance_merges, 0u);
    EXPECT_NEAR(welded.farthest, 1e-6, 1e-7);
}

TEST(Weld, ToleranceIsRelativeToTheBox) {
    EXPECT_GT(weld_unpainted(box_with_crack(1e-4)).positions.size(), 8u);
    EXPECT_EQ(weld_unpainted(box_with_crack(1e-4), 1e-3).positions.size(), 8u);
    for (const double scale : {1e-6, 1e4}) {
        Surface surface = box_with_crack(1e-6);
        for (Vec3& p : surface.positions) p = round_to_float(p * scale);
        EXPECT_EQ(weld_unpainted(surface).positions.size(), 8u) << scale;
    }
}

TEST(Weld, AChainOfNearVerticesDoesNotCollapse) {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    for (int i = 0; i < 100; ++i) {
        positions.push_back(round_to_float({i * 0.6e-6, 0, 0}));
        positions.push_back({0, 1, 0});
        positions.push_back({0, 0, 1});
        const auto first = static_cast<Index>(3 * i);
        triangles.push_back({first, first + 1, first + 2});
    }
    const Welded welded = weld_unpainted(surface_of(positions, triangles));
    EXPECT_GT(welded.positions.size(), 30u);
    EXPECT_LT(welded.farthest, 2e-6);
}

TEST(Weld, ThePaintedCopyOfANearPairKeepsItsPlace) {
    Surface surface = box_with_crack(1e-6);
    PaintedVertices painted = paint_all(surface, Paint::free);
    // A corner outside the crack: its first copy lies 1e-6 away and is free.
    std::size_t locked = 9;
    while (surface.positions[locked] + Vec3{1e-6f, 0, 0} == surface.positions[0]) ++locked;
    painted.paint[locked] = Paint::locked;
    const Welded welded = weld(surface, painted, 1e-6);
    const auto found = std::find(welded.locked.begin(), welded.locked.end(), 1) - welded.locked.begin();
    EXPECT_EQ(welded.positions.at(static_cast<std::size_t>(found)), surface.positions[locked]);
}

TEST(Weld, ManyOpenVerticesInOnePlaneAreQuick) {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    for (Index i = 0; i < 15'000; ++i) {
        positions.push_back(round_to_float({0, i % 300 * 0.01, static_cast<double>(i / 300) * 0.01}));
        if (i % 3 == 2) triangles.push_back({i - 2, i - 1, i});
    }
    EXPECT_EQ(weld_unpainted(surface_of(positions, triangles)).positions.size(), 15'000u);
}

}
}
