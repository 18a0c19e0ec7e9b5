// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/crowded.h"

#include <gtest/gtest.h>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

std::uint64_t merge_all(TetMesh& mesh) {
    const Shell shell = small::shell_of(mesh);
    const SurfaceGuard guard(shell, {});
    WorkMesh work(mesh);
    const std::uint64_t merged = merge_crowded_nodes(work, guard, {});
    mesh = take_mesh(work);
    return merged;
}

// The box around node 8 with the tet 0 of it cut into four by a node next to node 8.
TetMesh crowded_box(double away) {
    TetMesh mesh = small::box_around({0.5, 0.5, 0.5});
    const Tet cut = mesh.tets[0];
    const auto& p = mesh.positions;
    const Vec3 middle = (p[cut[0]] + p[cut[1]] + p[cut[2]]) / 3;
    mesh.positions.push_back(round_to_float(p[8] + (middle - p[8]) * away));
    mesh.tets.erase(mesh.tets.begin());
    for (int corner = 0; corner < 4; ++corner) {
        Tet part = cut;
        part[corner] = 9;
        mesh.tets.push_back(part);
    }
    mesh.neighbours = neighbours_of(mesh.tets);
    mesh.region.assign(mesh.tets.size(), 0);
    return mesh;
}

TEST(Crowded, NodesWithRoomStay) {
    TetMesh empty;
    EXPECT_EQ(merge_all(empty), 0u);
    TetMesh mesh = crowded_box(0.5);
    ASSERT_TRUE(small::is_all_positive(mesh));
    EXPECT_EQ(merge_all(mesh), 0u);
}

TEST(Crowded, ANodeNextToAnotherMergesIntoIt) {
    TetMesh mesh = crowded_box(1e-3);
    ASSERT_TRUE(small::is_all_positive(mesh));
    EXPECT_EQ(merge_all(mesh), 1u);
    EXPECT_EQ(mesh.tets.size(), 12u);
    EXPECT_EQ(mesh.positions.size(), 9u);
    EXPECT_TRUE(small::is_all_positive(mesh));
    EXPECT_NEAR(small::volume_of(mesh), 1, 1e-12);
}

TEST(Crowded, AShellVertexNextToAnotherStays) {
    TetMesh mesh = crowded_box(1e-3);
    mesh.shell_vertex_count = 10;
    EXPECT_EQ(merge_all(mesh), 0u);
}

}
}
