// SPDX-License-Identifier: GPL-3.0-or-later
// A shell taken through the stages before recover, and what must hold after it whatever the shell is like.
#pragma once
#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>

#include "cull/cull.h"
#include "delaunay/delaunay.h"
#include "exact_volume.h"
#include "geometry/predicates.h"
#include "mesh/validate.h"
#include "recover/constraints.h"
#include "recover/crossings.h"
#include "recover/recover.h"
#include "sample/sample.h"

namespace crumple::recover {

inline TetMesh delaunay_of(const Shell& shell, const std::string& count = "0") {
    sample::Params params;
    params.points = count;
    return delaunay::tetrahedralize(sample::sample_interior(shell, params).points).mesh;
}

inline void expect_sound(const Shell& shell, const TetMesh& before, const TetMesh& after) {
    for (const Finding& finding : validate(after)) ADD_FAILURE() << finding.code << ": " << finding.message;
    ASSERT_GE(after.positions.size(), before.positions.size());
    ASSERT_EQ(after.shell_vertex_count, shell.positions.size());
    for (std::size_t v = 0; v < before.positions.size(); ++v) {
        ASSERT_EQ(std::memcmp(&after.positions[v], &before.positions[v], sizeof(Vec3)), 0) << "node " << v << " moved";
    }
    EXPECT_EQ(exact_six_volumes(after), exact_six_volumes(before)) << "the hull is filled as before, to the last bit";
    std::set<Index> used;
    for (const Tet& tet : after.tets) used.insert(tet.begin(), tet.end());
    for (auto v = static_cast<Index>(before.positions.size()); v < after.positions.size(); ++v)
        EXPECT_TRUE(used.contains(v)) << "an added node that no tet uses";
}

// By brute force: no edge of the tets passes through a triangle of the shell, no edge of the shell through a face of
// the tets. Then every tet lies on one side.
inline void expect_no_crossing(const Shell& shell, const TetMesh& mesh) {
    std::set<Edge> edges;
    std::set<Triangle> faces;
    for (const Tet& tet : mesh.tets) {
        for (const auto& [i, j] : tet_edge_corners) edges.insert(sorted_edge(tet[i], tet[j]));
        for (const auto& face : tet_face_corners)
            faces.insert(sorted_triangle(tet[face[0]], tet[face[1]], tet[face[2]]));
    }
    const auto at = [&](Index v) { return mesh.positions[v]; };
    std::size_t crossings = 0;
    for (const Triangle& t : shell.triangles) {
        for (const Edge& e : edges) crossings += pierces(at(e[0]), at(e[1]), at(t[0]), at(t[1]), at(t[2]));
        for (int i = 0; i < 3; ++i) {
            const Edge e = sorted_edge(t[i], t[(i + 1) % 3]);
            if (edges.contains(e)) continue;
            for (const Triangle& f : faces) crossings += pierces(at(e[0]), at(e[1]), at(f[0]), at(f[1]), at(f[2]));
        }
    }
    EXPECT_EQ(crossings, 0u);
}

// Everything is back, and cull finds the shell's volume without asking samples.
inline void expect_whole(const Shell& shell, const Result& result) {
    EXPECT_EQ(result.report.missing_edges, result.report.negligible_edges);
    EXPECT_EQ(result.report.missing_triangles, result.report.negligible_triangles);
    EXPECT_EQ(result.report.steiner_points, 0u);
    EXPECT_TRUE(result.report.findings.empty());
    const cull::Report report = cull::cull_outside(shell, result.mesh).report;
    EXPECT_TRUE(report.shell_volume_is_exact);
    EXPECT_LT(report.volume_error, 1e-9);
    EXPECT_EQ(report.non_manifold_edges, 0u);
    EXPECT_EQ(report.pieces, report.shell_pieces);
}

}
