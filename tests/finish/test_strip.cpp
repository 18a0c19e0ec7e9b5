// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/strip.h"

#include <gtest/gtest.h>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

// Two good tets below the edge (0, 1) and over it the tet (0, 1, 2, 3) of the given height.
TetMesh bandaged(double height) {
    return small::mesh_of({{0, -1, 0}, {0, 1, 0}, {1, 0, height}, {-1, 0, height}, {0, 0, -1}},
                          {{0, 1, 3, 2}, {0, 1, 2, 4}, {0, 1, 4, 3}}, 5);
}

std::uint64_t strip(TetMesh& mesh, const Shell& shell) {
    const SurfaceGuard guard(shell, {});
    return strip_flat_tets(mesh, guard, {});
}

TEST(Strip, NothingOfNothing) {
    TetMesh mesh;
    EXPECT_EQ(strip(mesh, {}), 0u);
}

TEST(Strip, TakesWhatHasNoThicknessAndOnlyThat) {
    TetMesh flat = bandaged(1e-6);
    ASSERT_TRUE(small::is_all_positive(flat));
    EXPECT_EQ(strip(flat, small::shell_of(bandaged(1e-6))), 1u);
    EXPECT_EQ(flat.tets.size(), 2u);
    EXPECT_EQ(flat.neighbours, neighbours_of(flat.tets));
    EXPECT_EQ(flat.region.size(), 2u);
    TetMesh thin = bandaged(1e-3);
    EXPECT_EQ(strip(thin, small::shell_of(bandaged(1e-3))), 0u);
}

TEST(Strip, AFlapOverNothingGoes) {
    // The two flat tets over a tet that is not there: both sides of them show.
    TetMesh mesh = small::mesh_of(
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 1e-6}, {0, 1, 0}, {0.5, 0.5, 2e-6}, {0, 0, -1}, {1, 0, -1}, {0, 1, -1}},
        {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 6, 5, 7}}, 8);
    ASSERT_TRUE(small::is_all_positive(mesh));
    mesh.shell_vertex_count = 0;
    EXPECT_EQ(strip(mesh, small::shell_of(bandaged(1))), 2u);
    EXPECT_EQ(mesh.tets.size(), 1u);
}

TEST(Strip, TheLastTetOfAShellVertexStaysAndSoDoesAPaintedEdge) {
    TetMesh alone = small::mesh_of({{0, -1, 0}, {0, 1, 0}, {1, 0, 1e-6}, {-1, 0, 1e-6}}, {{0, 1, 3, 2}}, 4);
    EXPECT_EQ(strip(alone, small::shell_of(bandaged(1e-6))), 0u);
    TetMesh painted = bandaged(1e-6);
    Shell shell = small::shell_of(painted);
    shell.locked[2] = shell.locked[3] = 1;
    EXPECT_EQ(strip(painted, shell), 0u);
}

}
}
