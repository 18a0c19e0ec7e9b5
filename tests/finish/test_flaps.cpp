// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/flaps.h"

#include <gtest/gtest.h>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

constexpr PeelLimits generous{.angle_deg = 12, .share_of_edge = 0.05, .volume = 1};

// A tet (0, 1, 2, 3) whose face (0, 1, 2) looks up, and a flap on it: the tet over that face with the tip 4, which lies
// `lift` above the middle of its edge (0, 1).
TetMesh with_flap(double lift, Index shell_vertex_count) {
    return small::mesh_of({{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0.4, -1}, {0, 0, lift}}, {{0, 2, 1, 3}, {0, 1, 2, 4}},
                          shell_vertex_count);
}

PeelReport clip(WorkMesh& work, const Shell& shell, const PeelLimits& limits = generous) {
    return clip_flaps(work, SurfaceGuard(shell, {}), limits, {});
}

Shell shell_below(const TetMesh& mesh) {
    TetMesh body = mesh;
    body.tets.resize(1);
    body.region.resize(1);
    body.neighbours = neighbours_of(body.tets);
    return small::shell_of(body);
}

TEST(Flaps, TheFlapIsWhatTheTestsSay) { ASSERT_TRUE(small::is_all_positive(with_flap(1e-4, 5))); }

TEST(Flaps, AFlapGoesWithANodeThatIsNoneOfTheShells) {
    const TetMesh mesh = with_flap(1e-4, 4);
    WorkMesh work(mesh);
    const PeelReport report = clip(work, shell_below(mesh));
    EXPECT_EQ(report.removed, 1u);
    EXPECT_NEAR(report.spent, small::volume_of(mesh) - 1.0 / 3, 1e-7);
    const TetMesh clipped = take_mesh(work);
    EXPECT_EQ(clipped.tets.size(), 1u);
    EXPECT_EQ(clipped.positions.size(), 4u);
}

TEST(Flaps, AShellVertexIsSeatedOnTheSurfaceBeside) {
    const TetMesh mesh = with_flap(1e-4, 5);
    WorkMesh work(mesh);
    EXPECT_EQ(clip(work, small::shell_of(mesh)).removed, 1u);
    const TetMesh clipped = take_mesh(work);
    EXPECT_EQ(clipped.tets.size(), 2u) << "the edge below it is split";
    EXPECT_EQ(clipped.positions, mesh.positions);
    EXPECT_TRUE(small::is_all_positive(clipped));
    for (const Tet& tet : clipped.tets) EXPECT_TRUE(std::find(tet.begin(), tet.end(), 4u) != tet.end());
    EXPECT_TRUE(non_manifold(boundary_of(clipped).faces).vertices.empty());
    EXPECT_NEAR(small::volume_of(clipped), small::volume_of(mesh), 1e-3);
}

TEST(Flaps, WhatIsThickOrDearOrFarFromTheSurfaceStays) {
    const TetMesh thick = with_flap(0.3, 4);
    WorkMesh work(thick);
    EXPECT_EQ(clip(work, shell_below(thick)).removed, 0u);
    const TetMesh thin = with_flap(1e-4, 4);
    PeelLimits limits = generous;
    limits.volume = 1e-9;
    WorkMesh dear(thin);
    EXPECT_EQ(clip(dear, shell_below(thin), limits).removed, 0u);
    // Flat, but by more than the surface may move.
    const TetMesh far = with_flap(0.03, 5);
    WorkMesh too_far(far);
    EXPECT_EQ(clip(too_far, small::shell_of(far)).removed, 0u);
}

TEST(Flaps, ALoneTetStays) {
    TetMesh mesh = with_flap(1e-4, 5);
    mesh.tets.erase(mesh.tets.begin());
    mesh.region.resize(1);
    mesh.neighbours = neighbours_of(mesh.tets);
    WorkMesh work(mesh);
    EXPECT_EQ(clip(work, small::shell_of(mesh)).removed, 0u);
}

bool has_edge(const Exchange& exchange, Index a, Index b) {
    return std::any_of(exchange.fresh.begin(), exchange.fresh.end(), [&](const Tet& tet) {
        return std::find(tet.begin(), tet.end(), a) != tet.end() && std::find(tet.begin(), tet.end(), b) != tet.end();
    });
}

TEST(Flaps, APaintedEdgeIsNotSplit) {
    const TetMesh mesh = with_flap(1e-4, 5);
    Shell shell = small::shell_of(mesh);
    Exchange exchange;
    ASSERT_TRUE(plan_seat(WorkMesh(mesh), SurfaceGuard(shell, {}), 1, 4, 0.01, exchange));
    EXPECT_FALSE(has_edge(exchange, 0, 1));
    shell.locked[0] = shell.locked[1] = 1;
    EXPECT_FALSE(plan_seat(WorkMesh(mesh), SurfaceGuard(shell, {}), 1, 4, 0.01, exchange));
}

TEST(Flaps, APaintedEdgeOfTheTipIsNotLost) {
    // Two tets side by side; the flap on one reaches over the other.
    const TetMesh mesh = small::mesh_of({{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, -0.4, 1e-4}, {0, -1, 0}},
                                        {{0, 2, 1, 3}, {0, 1, 2, 4}, {0, 1, 5, 3}}, 6);
    ASSERT_TRUE(small::is_all_positive(mesh));
    Shell shell = small::shell_of(mesh);
    Exchange exchange;
    ASSERT_TRUE(plan_seat(WorkMesh(mesh), SurfaceGuard(shell, {}), 1, 4, 0.01, exchange));
    EXPECT_FALSE(has_edge(exchange, 4, 2)) << "seated on the other one's face";
    shell.locked[0] = shell.locked[1] = shell.locked[2] = shell.locked[4] = 1;
    EXPECT_FALSE(plan_seat(WorkMesh(mesh), SurfaceGuard(shell, {}), 1, 4, 0.01, exchange));
}

}
}
