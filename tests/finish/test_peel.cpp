// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/peel.h"

#include <gtest/gtest.h>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

// Two tets beside each other below the edge (0, 1), and over it, like a bandage, the flat tet (0, 1, 2, 3), whose outer
// edge is (2, 3).
TetMesh bandaged(double height = 0.02) {
    return small::mesh_of({{0, -1, 0}, {0, 1, 0}, {1, 0, height}, {-1, 0, height}, {0, 0, -1}},
                          {{0, 1, 3, 2}, {0, 1, 2, 4}, {0, 1, 4, 3}}, 5);
}

PeelReport peel(WorkMesh& work, const Shell& shell, PeelLimits limits) {
    const SurfaceGuard guard(shell, {});
    return peel_flat_tets(work, guard, limits, {});
}

constexpr PeelLimits generous{.angle_deg = 12, .share_of_edge = 0.05, .volume = 1};

TEST(Peel, TheBandageIsWhatTheTestsSay) {
    const TetMesh mesh = bandaged();
    ASSERT_TRUE(small::is_all_positive(mesh));
    EXPECT_TRUE(non_manifold(boundary_of(mesh).faces).vertices.empty());
}

TEST(Peel, TakesAFlatTetOffAndLeavesAManifold) {
    const TetMesh mesh = bandaged();
    WorkMesh work(mesh);
    const PeelReport report = peel(work, small::shell_of(mesh), generous);
    EXPECT_EQ(report.removed, 1u);
    EXPECT_EQ(report.restored, 0u);
    const TetMesh peeled = take_mesh(work);
    EXPECT_EQ(peeled.tets.size(), 2u);
    EXPECT_NEAR(small::volume_of(mesh) - small::volume_of(peeled), report.volume, 1e-12);
    EXPECT_TRUE(non_manifold(boundary_of(peeled).faces).vertices.empty());
    EXPECT_TRUE(non_manifold(boundary_of(peeled).faces).edges.empty());
}

TEST(Peel, LeavesWhatIsThickOrDear) {
    const TetMesh mesh = bandaged(0.2);
    WorkMesh work(mesh);
    EXPECT_EQ(peel(work, small::shell_of(mesh), generous).removed, 0u);
    const TetMesh flat = bandaged();
    WorkMesh dear(flat);
    PeelLimits limits = generous;
    limits.volume = 1e-6;
    EXPECT_EQ(peel(dear, small::shell_of(flat), limits).removed, 0u);
    limits = generous;
    limits.share_of_edge = 1e-4;
    EXPECT_EQ(peel(dear, small::shell_of(flat), limits).removed, 0u);
    limits = generous;
    limits.angle_deg = 0.1;
    EXPECT_EQ(peel(dear, small::shell_of(flat), limits).removed, 0u);
}

TEST(Peel, LeavesAPaintedEdge) {
    const TetMesh mesh = bandaged();
    Shell shell = small::shell_of(mesh);
    shell.locked[2] = shell.locked[3] = 1;
    WorkMesh work(mesh);
    EXPECT_EQ(peel(work, shell, generous).removed, 0u);
}

TEST(Peel, LeavesAnotherMaterial) {
    TetMesh mesh = bandaged();
    mesh.region[0] = 1;
    WorkMesh work(mesh);
    EXPECT_EQ(peel(work, small::shell_of(mesh), generous).removed, 0u);
}

TEST(Peel, TakesOffATetOfAnyShapeThatLiesOutsideTheShell) {
    const TetMesh mesh = bandaged(0.5);
    TetMesh inside = mesh;
    inside.tets.erase(inside.tets.begin());
    inside.region.pop_back();
    inside.neighbours = neighbours_of(inside.tets);
    WorkMesh work(mesh);
    PeelLimits limits = generous;
    limits.volume = 0;
    const PeelReport report = peel(work, small::shell_of(inside), limits);
    EXPECT_EQ(report.removed, 1u);
    EXPECT_EQ(report.restored, 1u);
    EXPECT_EQ(report.spent, 0);
}

TEST(Peel, NeverTakesATetWhoseInnerEdgeShows) {
    // Without the tet (0, 1, 3, 4) the edge (0, 1) is on the surface already: taking the bandage would pinch it.
    TetMesh mesh = bandaged();
    mesh.tets.pop_back();
    mesh.region.pop_back();
    mesh.neighbours = neighbours_of(mesh.tets);
    WorkMesh work(mesh);
    EXPECT_EQ(peel(work, small::shell_of(mesh), generous).removed, 0u);
}

}
}
