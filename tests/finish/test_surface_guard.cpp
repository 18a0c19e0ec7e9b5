// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/surface_guard.h"

#include <gtest/gtest.h>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

// Two tets under a square (0, 1, 2, 3) whose diagonal is the edge (0, 2); node 1 may be lifted, node 4 lies below.
TetMesh roof(double lift) {
    return small::mesh_of({{0, 0, 0}, {1, 0, lift}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, -1}}, {{0, 2, 1, 4}, {0, 3, 2, 4}},
                          5);
}

// The faces (a, p, b) and (a, b, q) of the roof are (0, 1, 2) and (0, 2, 3).
bool may_flip(const TetMesh& mesh, const Shell& shell, const SurfaceLimits& limits = {}) {
    return SurfaceGuard(shell, limits).may_flip(WorkMesh(mesh), 0, 2, 1, 3);
}

// A part of the shell that hangs from above down to its tip.
void add_tet(Shell& shell, Vec3 tip) {
    const Index first = static_cast<Index>(shell.positions.size());
    for (const Vec3 by : {Vec3{}, Vec3{0.1, 0, 0.5}, Vec3{0, 0.1, 0.5}, Vec3{-0.1, -0.1, 0.5}})
        shell.positions.push_back(tip + by);
    for (const auto& face : tet_face_corners)
        shell.triangles.push_back({first + face[0], first + face[1], first + face[2]});
    shell.component.resize(shell.triangles.size(), 0);
    shell.locked.resize(shell.positions.size(), 0);
}

TEST(SurfaceGuard, TheRoofIsWhatTheTestsSay) {
    const TetMesh mesh = roof(0);
    ASSERT_TRUE(small::is_all_positive(mesh));
    const SurfaceGuard guard(small::shell_of(mesh), {});
    EXPECT_TRUE(guard.is_shell_triangle(0, 1, 2));
    EXPECT_TRUE(guard.is_shell_triangle(2, 0, 1));
    EXPECT_FALSE(guard.is_shell_triangle(0, 2, 1));
}

TEST(SurfaceGuard, AFlatDiagonalMayFlip) {
    const TetMesh mesh = roof(0);
    EXPECT_TRUE(may_flip(mesh, small::shell_of(mesh)));
}

TEST(SurfaceGuard, AFoldBeyondTheLimitMayNot) {
    SurfaceLimits wide;
    wide.share_of_edge = 1;
    wide.share_of_diagonal = 1;
    for (const double lift : {-0.1, 0.1}) {
        const TetMesh mesh = roof(lift);
        EXPECT_FALSE(may_flip(mesh, small::shell_of(mesh), wide));
        wide.fold_deg = 15;
        EXPECT_EQ(may_flip(mesh, small::shell_of(mesh), wide), lift < 0 || lift > 0);
        wide.fold_deg = 0.5;
    }
}

TEST(SurfaceGuard, ASurfaceThatWouldMoveTooFarMayNot) {
    const TetMesh mesh = roof(0.01);
    SurfaceLimits limits;
    limits.fold_deg = 30;
    limits.share_of_diagonal = 1;
    limits.share_of_edge = 0.01;
    EXPECT_TRUE(may_flip(mesh, small::shell_of(mesh), limits));
    limits.share_of_edge = 0.001;
    EXPECT_FALSE(may_flip(mesh, small::shell_of(mesh), limits));
    limits.share_of_edge = 0.01;
    limits.share_of_diagonal = 0.001;
    EXPECT_FALSE(may_flip(mesh, small::shell_of(mesh), limits));
}

TEST(SurfaceGuard, AConcaveFourSidedPatchMayNot) {
    TetMesh mesh = roof(0);
    mesh.positions[1] = {0.25f, 0.5f, 0};  // beyond the diagonal's end: the new faces would overlap
    mesh.positions[0] = {0.3f, 0.6f, 0};
    ASSERT_TRUE(small::is_all_positive(mesh));
    EXPECT_FALSE(may_flip(mesh, small::shell_of(mesh)));
}

TEST(SurfaceGuard, APaintedEdgeMayNotButOnePaintedEndIsNoEdge) {
    const TetMesh mesh = roof(0);
    Shell shell = small::shell_of(mesh);
    shell.locked[0] = 1;
    EXPECT_TRUE(may_flip(mesh, shell));
    shell.locked[2] = 1;
    EXPECT_FALSE(may_flip(mesh, shell));
}

TEST(SurfaceGuard, AnEdgeBetweenTwoComponentsMayNot) {
    const TetMesh mesh = roof(0);
    Shell shell = small::shell_of(mesh);
    shell.components.emplace_back().name = "glass";
    const SurfaceGuard guard(shell, {});
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        const Triangle& t = shell.triangles[f];
        if (std::find(t.begin(), t.end(), 1u) != t.end()) shell.component[f] = 1;
    }
    EXPECT_FALSE(may_flip(mesh, shell));
}

TEST(SurfaceGuard, NewFacesOutsideTheOldOnesKeepAwayFromOtherParts) {
    // A valley: the new diagonal passes above it. Another part of the shell hangs just there.
    const TetMesh mesh = roof(0.003);
    SurfaceLimits limits;
    Shell shell = small::shell_of(mesh);
    ASSERT_TRUE(may_flip(mesh, shell, limits));
    add_tet(shell, {0.5, 0.5, 0.001});
    EXPECT_FALSE(may_flip(mesh, shell, limits));
}

TEST(SurfaceGuard, OtherPartsBesideAndBehindTheNewFacesAreNotInTheWay) {
    const TetMesh mesh = roof(0.003);
    for (const Vec3 tip : {Vec3{0.5, 0.5, 0.1}, Vec3{1.3, 1.3, 0.001}, Vec3{0.5, 0.5, -0.8}}) {
        Shell shell = small::shell_of(mesh);
        add_tet(shell, tip);
        EXPECT_TRUE(may_flip(mesh, shell)) << tip.x << ' ' << tip.z;
    }
}

TEST(SurfaceGuard, AtAFoldTheSurfaceMayMoveLess) {
    // The lifted node is that of a flat triangle: hardly beyond the diagonal, so its fold means nothing.
    TetMesh mesh = roof(0);
    mesh.positions[1] = {0.501f, 0.499f, 0.0002f};
    ASSERT_TRUE(small::is_all_positive(mesh));
    SurfaceLimits limits;
    EXPECT_TRUE(may_flip(mesh, small::shell_of(mesh), limits));
    limits.share_of_edge_folded = 0;
    EXPECT_FALSE(may_flip(mesh, small::shell_of(mesh), limits));
    limits.fold_deg = 15;
    EXPECT_TRUE(may_flip(mesh, small::shell_of(mesh), limits)) << "then it is no fold";
}

TEST(SurfaceGuard, ACreaseStaysHoweverNearTheOtherDiagonalIs) {
    TetMesh mesh = roof(0);
    mesh.positions[1] = {0.5001f, 0.4999f, 0.0002f};
    ASSERT_TRUE(small::is_all_positive(mesh));
    EXPECT_FALSE(may_flip(mesh, small::shell_of(mesh)));
}

TEST(SurfaceGuard, TheGapIsTheDistanceOfTheTwoLines) {
    EXPECT_DOUBLE_EQ(gap_between({0, 0, 0}, {1, 1, 0}, {1, 0, 2}, {0, 1, 2}), 2);
    EXPECT_EQ(gap_between({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}), 0);
}

}
}
