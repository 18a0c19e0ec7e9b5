// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/surface_operations.h"

#include <gtest/gtest.h>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

// A square pyramid whose base is a fan around node 5, which is none of the shell's; apex 4 below.
TetMesh fanned(Vec3 hub) {
    return small::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, -1}, hub},
                          {{5, 1, 0, 4}, {5, 2, 1, 4}, {5, 3, 2, 4}, {5, 0, 3, 4}}, 5);
}

Shell pyramid() {
    return small::shell_of(
        small::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, -1}}, {{0, 2, 1, 4}, {0, 3, 2, 4}}, 5));
}

bool contract(const TetMesh& mesh, const Shell& shell, Index target, TetMesh* result = nullptr) {
    WorkMesh work(mesh);
    const SurfaceGuard guard(shell, {});
    std::vector<Index> star;
    work.complex.star_of(5, star);
    Exchange exchange;
    if (!plan_surface_operations(work, guard, 5, star, target, 0, exchange)) return false;
    (void)apply(work, exchange);
    if (result) *result = take_mesh(work);
    return true;
}

TEST(SurfaceContraction, ANodeThatIsNoneOfTheShellsIsSurplus) {
    const TetMesh mesh = fanned({0.5, 0.5, 0});
    ASSERT_TRUE(small::is_all_positive(mesh));
    const WorkMesh work(mesh);
    EXPECT_TRUE(work.is_surplus[5]);
    EXPECT_FALSE(work.is_surplus[0]);
    EXPECT_FALSE(work.is_free[5]);
}

TEST(SurfaceContraction, OnAFlatFaceItMergesIntoACorner) {
    TetMesh result;
    ASSERT_TRUE(contract(fanned({0.5, 0.5, 0}), pyramid(), 0, &result));
    EXPECT_EQ(result.tets.size(), 2u);
    EXPECT_EQ(result.positions.size(), 5u);
    EXPECT_NEAR(small::volume_of(result), 1.0 / 3, 1e-12);
    EXPECT_TRUE(non_manifold(boundary_of(result).faces).vertices.empty());
}

TEST(SurfaceContraction, OneThatHoldsUpTheSurfaceStays) {
    EXPECT_FALSE(contract(fanned({0.5, 0.5, 0.2}), pyramid(), 0));
    EXPECT_FALSE(contract(fanned({0.5, 0.5, -0.2}), pyramid(), 0)) << "the hollow would be filled";
}

TEST(SurfaceContraction, IntoANodeInsideOrWhereATetWouldTurnItStays) {
    EXPECT_FALSE(contract(fanned({0.5, 0.5, 0}), pyramid(), 4));  // the apex is on the surface, but far away
}

TEST(SurfaceContraction, APaintedEdgeKeepsItsNode) {
    Shell shell = pyramid();
    shell.locked[0] = shell.locked[2] = 1;
    EXPECT_FALSE(contract(fanned({0.5, 0.5, 0}), shell, 1));
    EXPECT_TRUE(contract(fanned({0.5, 0.5, 0}), shell, 0));
}

}
}
