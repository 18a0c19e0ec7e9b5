// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/edge_removal.h"

#include <gtest/gtest.h>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

// Takes the edge (0, 1) out of a mesh, if that can be planned.
struct Removed {
    RemovalResult result;
    Exchange exchange;
    TetMesh mesh;
};

Removed remove_edge(const TetMesh& mesh, double floor = 0, const SurfaceGuard* guard = nullptr) {
    WorkMesh work(mesh);
    TetRing ring;
    work.complex.ring_of(work.complex.find_edge(0, 1), 0, 1, ring);
    Removed removed;
    removed.result = plan_edge_removal(work, guard, ring, 0, 1, floor, removed.exchange);
    if (removed.result != RemovalResult::none) (void)apply(work, removed.exchange);
    removed.mesh = take_mesh(work);
    return removed;
}

TEST(EdgeRemoval, ASingleTetKeepsItsEdges) {
    const TetMesh mesh = small::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}, 4);
    EXPECT_EQ(remove_edge(mesh).result, RemovalResult::none);
}

TEST(EdgeRemoval, RingsOfThreeToEightFillTheSameSpaceWithoutTheEdge) {
    for (int n = 3; n <= 8; ++n) {
        const TetMesh mesh = small::ring(n, 3);  // the edge is long: it pays to take it out
        const double floor = small::worst_of(mesh);
        const Removed removed = remove_edge(mesh, floor);
        ASSERT_EQ(removed.result, RemovalResult::interior) << n;
        EXPECT_EQ(removed.mesh.tets.size(), 2u * (n - 2));
        EXPECT_TRUE(small::is_all_positive(removed.mesh));
        EXPECT_NEAR(small::volume_of(removed.mesh), small::volume_of(mesh), 1e-12);
        EXPECT_EQ(small::worst_of(removed.mesh), removed.exchange.least);
        EXPECT_GT(small::worst_of(removed.mesh), floor);
        EXPECT_EQ(removed.mesh.positions, mesh.positions);
        EXPECT_EQ(WorkMesh(removed.mesh).complex.find_edge(0, 1), none);
        EXPECT_EQ(boundary_of(removed.mesh).faces.size(), boundary_of(mesh).faces.size());
    }
}

TEST(EdgeRemoval, WhatDoesNotBeatTheFloorIsLeft) {
    const TetMesh mesh = small::ring(5, 0.2);
    const double least = remove_edge(mesh).exchange.least;
    EXPECT_EQ(remove_edge(mesh, least).result, RemovalResult::none);
    EXPECT_EQ(remove_edge(mesh, least * 0.999).result, RemovalResult::interior);
}

TEST(EdgeRemoval, AnEdgeBetweenTwoMaterialsStays) {
    TetMesh mesh = small::ring(6, 0.2);
    mesh.region[3] = 1;
    EXPECT_EQ(remove_edge(mesh).result, RemovalResult::none);
}

// Half of a ring of eight: the edge lies on the flat side, between the nodes 2 and 6.
TetMesh half_ring() {
    TetMesh mesh = small::ring(8, 0.2);
    mesh.tets.resize(4);
    mesh.positions.resize(7);
    mesh.positions[2] = {1, 0, 0};
    mesh.positions[6] = {-1, 0, 0};
    mesh.shell_vertex_count = 7;
    mesh.neighbours = neighbours_of(mesh.tets);
    mesh.region.resize(4);
    return mesh;
}

TEST(EdgeRemoval, AnEdgeOfTheSurfaceGoesOnlyWhereTheGuardAgrees) {
    const TetMesh mesh = half_ring();
    EXPECT_EQ(remove_edge(mesh).result, RemovalResult::none);
    Shell shell = small::shell_of(mesh);
    const SurfaceGuard guard(shell, {});
    const Removed removed = remove_edge(mesh, 0, &guard);
    ASSERT_EQ(removed.result, RemovalResult::surface);
    EXPECT_EQ(removed.mesh.tets.size(), 6u);
    EXPECT_TRUE(small::is_all_positive(removed.mesh));
    EXPECT_NEAR(small::volume_of(removed.mesh), small::volume_of(mesh), 1e-12);
    EXPECT_TRUE(non_manifold(boundary_of(removed.mesh).faces).vertices.empty());

    shell.locked[0] = shell.locked[1] = 1;
    const SurfaceGuard strict(shell, {});
    EXPECT_EQ(remove_edge(mesh, 0, &strict).result, RemovalResult::none) << "the edge is painted";
}

}
}
