// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/recover.h"

#include <gtest/gtest.h>

#include "hard_shells.h"
#include "recovered.h"

using namespace crumple;
using namespace crumple::recover;

namespace {

TEST(Recover, OffChangesNothing) {
    const Shell shell = shapes::twisted_prism();
    const TetMesh before = delaunay_of(shell);
    Params params;
    params.mode = Mode::off;
    const Result result = recover_shell(before, shell, params);
    EXPECT_EQ(result.mesh.tets, before.tets);
    EXPECT_EQ(result.report.edges, 0u);
}

TEST(Recover, WhatIsThereStaysAsItIs) {
    const Shell shell = shapes::tetrahedron();
    const TetMesh before = delaunay_of(shell);
    const Result result = recover_shell(before, shell);
    EXPECT_EQ(result.mesh.tets.size(), 1u);
    EXPECT_EQ(result.report.edges, 6u);
    EXPECT_EQ(result.report.triangles, 4u);
    EXPECT_EQ(result.report.exchanges, 0u);
}

TEST(Recover, CoplanarDiagonalsAreNegligible) {
    for (const Shell& shell :
         {shapes::box(), shapes::nested_boxes(), shapes::subdivided_box(3), shapes::thin_plate()}) {
        const TetMesh before = delaunay_of(shell, "20");
        const Report report = recover_shell(before, shell).report;
        EXPECT_GT(report.missing_edges_before, 0u);
        EXPECT_EQ(report.negligible_edges, report.missing_edges);
        EXPECT_EQ(report.negligible_triangles, report.missing_triangles);
        EXPECT_EQ(report.exchanges, 0u) << "nothing to do";
        EXPECT_TRUE(report.findings.empty());
    }
}

TEST(Recover, ASecondRunFindsNothingToDo) {
    const Shell shell = shapes::knot(2, 3, 0.4, 40, 5);
    Params params;
    params.mode = Mode::always;
    const TetMesh once = recover_shell(delaunay_of(shell), shell, params).mesh;
    const Result twice = recover_shell(once, shell, params);
    EXPECT_EQ(twice.report.missing_edges_before, 0u);
    EXPECT_EQ(twice.report.exchanges, 0u);
    EXPECT_EQ(twice.report.added_nodes, 0u);
}

TEST(Recover, TheOrderOfTrianglesDoesNotMatter) {
    const Shell shell = shapes::knot(2, 3, 0.5, 40, 5);
    const TetMesh before = delaunay_of(shell, "30");
    const Result first = recover_shell(before, shell);
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const Result other = recover_shell(before, shapes::shuffled_triangles(shell, seed));
        EXPECT_EQ(other.mesh.tets, first.mesh.tets);
        EXPECT_EQ(other.mesh.positions, first.mesh.positions);
        EXPECT_EQ(other.mesh.neighbours, first.mesh.neighbours);
    }
}

// Vertices given in another order: the same tets at the same places.
TEST(Recover, TheOrderOfVerticesDoesNotMatter) {
    const Shell shell = shapes::twisted_prism(6, 3, 0.5);
    Shell reversed = shell;
    const auto count = static_cast<Index>(shell.positions.size());
    std::reverse(reversed.positions.begin(), reversed.positions.end());
    for (Triangle& t : reversed.triangles) {
        for (Index& v : t) v = count - 1 - v;
    }
    const auto places = [](const TetMesh& mesh) {
        std::multiset<std::vector<std::array<double, 3>>> tets;
        for (const Tet& tet : mesh.tets) {
            std::vector<std::array<double, 3>> corners;
            for (const Index v : tet)
                corners.push_back({mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z});
            std::sort(corners.begin(), corners.end());
            tets.insert(corners);
        }
        return tets;
    };
    const Result a = recover_shell(delaunay_of(shell), shell);
    const Result b = recover_shell(delaunay_of(reversed), reversed);
    EXPECT_EQ(places(a.mesh), places(b.mesh));
    EXPECT_EQ(a.report.exchanges, b.report.exchanges);
}

TEST(Recover, ScaleDoesNotMatter) {
    const Shell shell = shapes::knot(2, 3, 0.4, 40, 5);
    const Result first = recover_shell(delaunay_of(shell), shell);
    for (const double scale : {0x1p-20, 0x1p14}) {
        const Shell scaled = shapes::moved(shell, {0, 0, 0}, scale);
        const Result other = recover_shell(delaunay_of(scaled), scaled);
        EXPECT_EQ(other.mesh.tets, first.mesh.tets);
    }
}

TEST(Recover, InteriorNodesKeepTheirPlace) {
    const Shell shell = shapes::spiked_ball(2, 3, 2.5);
    const TetMesh before = delaunay_of(shell, "60");
    const Result result = recover_shell(before, shell);
    expect_sound(shell, before, result.mesh);
    EXPECT_GT(result.report.exchanges, 0u);
}

TEST(Recover, CulledTetsAreRefused) {
    const Shell shell = shapes::icosphere();
    const TetMesh culled = cull::cull_outside(shell, delaunay_of(shell)).mesh;
    try {
        const Result result = recover_shell(culled, shell);
        FAIL() << result.report.edges;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        EXPECT_NE(std::string(error.what()).find("culled"), std::string::npos);
    }
}

TEST(Recover, ACancelledRunStops) {
    const std::atomic<bool> cancelled = true;
    Context context;
    context.cancelled = &cancelled;
    const Shell shell = shapes::twisted_prism();
    const TetMesh before = delaunay_of(shell);
    EXPECT_THROW((void)recover_shell(before, shell, {}, context), Error);
}

}
