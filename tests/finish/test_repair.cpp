// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/repair.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/shapes.h"
#include "mesh/validate.h"
#include "small_meshes.h"

namespace crumple::finish {
namespace {

void expect_mended(const TetMesh& mesh) {
    const NonManifold before = non_manifold(boundary_of(mesh).faces);
    ASSERT_FALSE(before.vertices.empty());
    const Repaired repaired = repair_surface(mesh, {}, {});
    const NonManifold after = non_manifold(boundary_of(repaired.mesh).faces);
    EXPECT_TRUE(after.vertices.empty());
    EXPECT_TRUE(after.edges.empty());
    EXPECT_EQ(repaired.report.nodes_before, before.vertices.size());
    EXPECT_EQ(repaired.report.edges_before, before.edges.size());
    EXPECT_EQ(repaired.report.nodes_left, 0u);
    EXPECT_GT(repaired.report.removed + repaired.report.added + repaired.report.split, 0u);
    EXPECT_TRUE(small::is_all_positive(repaired.mesh));
    EXPECT_TRUE(validate(repaired.mesh, 1).empty());
    EXPECT_NEAR(small::volume_of(repaired.mesh),
                small::volume_of(mesh) - repaired.report.volume_removed + repaired.report.volume_added, 1e-12);
    // A tet or two, not a block.
    EXPECT_LT(repaired.report.volume_removed + repaired.report.volume_added, 0.7);
}

TEST(Repair, OfNothingIsNothing) {
    const Repaired repaired = repair_surface({}, {}, {});
    EXPECT_TRUE(repaired.mesh.tets.empty());
    EXPECT_EQ(repaired.report.nodes_before, 0u);
}

TEST(Repair, LeavesAManifoldAsItIs) {
    const TetMesh mesh = small::cells(3, [](int x, int y, int z) { return x != 1 || y != 1 || z != 2; });
    const Repaired repaired = repair_surface(mesh, {}, {});
    EXPECT_EQ(repaired.mesh.tets, mesh.tets);
    EXPECT_EQ(repaired.report.removed + repaired.report.added, 0u);
}

TEST(Repair, PartsOrJoinTwoBlocksThatShareAnEdge) {
    expect_mended(small::cells(2, [](int x, int y, int) { return x == y; }));
    expect_mended(small::cells(2, [](int x, int y, int) { return x != y; }));
}

TEST(Repair, PartsOrJoinTwoBlocksThatShareANode) {
    expect_mended(small::cells(2, [](int x, int y, int z) { return x == y && y == z; }));
    expect_mended(small::cells(2, [](int x, int y, int z) { return x != y && y == z; }));
}

TEST(Repair, OpensACavityThatTouchesTheOutside) {
    // A hole of one cell inside that shares an edge with a notch at the surface.
    expect_mended(small::cells(
        4, [](int x, int y, int z) { return !(x == 1 && y == 1 && z == 1) && !(x == 0 && y == 0 && z == 1); }));
}

TEST(Repair, ASpongeEndsSoundWhateverIsLeft) {
    const TetMesh whole = shapes::tet_grid(5);
    TetMesh mesh = whole;
    mesh.tets.clear();
    for (Index t = 0; t < whole.tets.size(); ++t) {
        if ((t * 2654435761u >> 7) % 3 != 0) mesh.tets.push_back(whole.tets[t]);
    }
    mesh.region.assign(mesh.tets.size(), 0);
    mesh.neighbours = neighbours_of(mesh.tets);
    const Repaired repaired = repair_surface(mesh, {}, {});
    EXPECT_LT(repaired.report.nodes_left, repaired.report.nodes_before / 4);
    EXPECT_TRUE(small::is_all_positive(repaired.mesh));
    EXPECT_TRUE(validate(repaired.mesh, 1).empty());
    EXPECT_EQ(non_manifold(boundary_of(repaired.mesh).faces).vertices.size(), repaired.report.nodes_left);
}

// Two tets that share node 0 and nothing else.
TetMesh bow_tie() {
    return small::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                          {{0, 1, 2, 3}, {0, 4, 6, 5}}, 7);
}

TEST(Repair, PartsThatShareOnlyANodeGetOneEach) {
    const TetMesh mesh = bow_tie();
    ASSERT_TRUE(small::is_all_positive(mesh));
    const Repaired repaired = repair_surface(mesh, {}, {});
    EXPECT_EQ(repaired.mesh.tets.size(), 2u) << "the last tet of a shell vertex stays";
    EXPECT_EQ(repaired.report.split, 1u);
    EXPECT_EQ(repaired.report.nodes_left, 0u);
    ASSERT_EQ(repaired.mesh.positions.size(), 8u);
    EXPECT_EQ(repaired.mesh.positions[7], mesh.positions[0]);
    EXPECT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.end(), repaired.mesh.positions.begin()));
}

TEST(Repair, TheLargestPartKeepsTheNode) {
    // The first tet is the smaller one.
    TetMesh mesh = bow_tie();
    for (Index v = 1; v < 4; ++v) mesh.positions[v] = mesh.positions[0] + (mesh.positions[v] - mesh.positions[0]) * 0.5;
    ASSERT_TRUE(small::is_all_positive(mesh));
    const Repaired repaired = repair_surface(mesh, {}, {});
    ASSERT_EQ(repaired.report.split, 1u);
    const Tet& smaller = repaired.mesh.tets[0];
    const Tet& larger = repaired.mesh.tets[1];
    EXPECT_TRUE(std::find(smaller.begin(), smaller.end(), 7u) != smaller.end());
    EXPECT_TRUE(std::find(larger.begin(), larger.end(), 0u) != larger.end());
}

TEST(Repair, ALockedNodeIsNotCopied) {
    const TetMesh mesh = bow_tie();
    const std::uint8_t locked[] = {1, 0, 0, 0, 0, 0, 0};
    const Repaired repaired = repair_surface(mesh, locked, {});
    EXPECT_EQ(repaired.report.split, 0u);
    EXPECT_EQ(repaired.report.cut, 1u) << "but one of its two tets is cut off it";
    EXPECT_EQ(repaired.report.nodes_left, 0u);
    EXPECT_EQ(std::count(repaired.mesh.positions.begin(), repaired.mesh.positions.end(), mesh.positions[0]), 1);
    EXPECT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.end(), repaired.mesh.positions.begin()));
    EXPECT_TRUE(small::is_all_positive(repaired.mesh));
    EXPECT_TRUE(non_manifold(boundary_of(repaired.mesh).faces).vertices.empty());
}

TEST(Repair, LockedMaterialGetsNoLooseNodes) {
    const TetMesh mesh = bow_tie();
    const std::uint8_t locked[] = {1, 1, 1, 1, 1, 1, 1};
    const Repaired repaired = repair_surface(mesh, locked, {});
    EXPECT_EQ(repaired.report.nodes_left, 1u) << "it is rigid: touching does no harm";
    EXPECT_EQ(repaired.mesh.positions, mesh.positions);
    EXPECT_EQ(repaired.mesh.tets, mesh.tets);
}

TEST(Repair, WhatFloatsCannotHoldIsSaid) {
    // So far out that nothing lies between two neighbouring places.
    TetMesh mesh = bow_tie();
    for (Vec3& p : mesh.positions) p = p * 2 + Vec3{1, 1, 1} * 16777216.0 * 2;
    for (Vec3& p : mesh.positions) p = round_to_float(p);
    const std::uint8_t locked[] = {1, 0, 0, 0, 0, 0, 0};
    const Repaired repaired = repair_surface(mesh, locked, {});
    EXPECT_EQ(repaired.report.nodes_left, 1u);
    EXPECT_EQ(repaired.mesh.positions, mesh.positions);
    EXPECT_EQ(repaired.mesh.tets, mesh.tets);
}

}
}
