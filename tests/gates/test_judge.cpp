// SPDX-License-Identifier: GPL-3.0-or-later
#include "gates/judge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "gates/baseline.h"
#include "mesh/neighbours.h"
#include "mesh/shapes.h"
#include "quality/uneven_grid.h"

using namespace crumple;
using namespace crumple::gates;
using quality::EmbeddingResult;
using quality::Figures;
using quality::HungVertex;
using quality::measure;
using quality::PlaceNames;

namespace {

std::vector<Finding> judged(const TetMesh& mesh, const Limits& params = {}, const PlaceNames& names = {}) {
    return judge(measure(mesh, nullptr), mesh, nullptr, params, names);
}

const Finding* find(const std::vector<Finding>& findings, const std::string& code) {
    const auto found = std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.code == code; });
    return found == findings.end() ? nullptr : &*found;
}

// A grid one node of which is moved so that tets around it are all but flat.
TetMesh squashed(double left) {
    TetMesh mesh = shapes::tet_grid(3);
    for (Vec3& p : mesh.positions) {
        if (p.x > 0.3 && p.x < 0.4 && p.y > 0.3 && p.y < 0.4 && p.z > 0.3 && p.z < 0.4) p = p * left;
    }
    return mesh;
}

TEST(Gates, NoTetsNothingToJudge) { EXPECT_TRUE(judged(TetMesh{}).empty()); }

TEST(Gates, AGoodMeshPassesAllOfThem) {
    const std::vector<Finding> findings = judged(shapes::tet_grid(3));
    EXPECT_TRUE(findings.empty()) << findings.front().code;
}

TEST(Gates, AnInvertedTetFailsWhateverTheLimits) {
    TetMesh mesh = shapes::tet_grid(2);
    std::swap(mesh.tets[3][0], mesh.tets[3][1]);
    Limits lax;
    lax.min_dihedral_deg = lax.dt_ratio = lax.volume_lrms3 = lax.radius_ratio = lax.p5_dihedral_deg = {0, 0};
    lax.max_dihedral_deg = lax.stiffness_ratio = lax.below_10_share = lax.non_manifold = {never, never};
    const std::vector<Finding> findings = judged(mesh, lax);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].code, "GATE_INVERTED");
    EXPECT_EQ(findings[0].severity, Severity::error);
    EXPECT_EQ(findings[0].places.at(0).element, 3u);
}

TEST(Gates, EachLimitFailsBeyondItsFigureAndWarnsBeyondTheOther) {
    const TetMesh mesh = squashed(0.2);
    const Figures figures = measure(mesh, nullptr);
    const auto severity = [&](double fail, double warn) {
        Limits params;
        params.min_dihedral_deg = {fail, warn};
        const std::vector<Finding> findings = judge(figures, mesh, nullptr, params);
        const Finding* finding = find(findings, "GATE_MIN_DIHEDRAL");
        return finding ? finding->severity : Severity::info;
    };
    const double angle = figures.shape.min_dihedral_deg;
    EXPECT_EQ(severity(angle, angle), Severity::info) << "the limit itself is allowed";
    EXPECT_EQ(severity(angle - 0.1, angle + 0.1), Severity::warning);
    EXPECT_EQ(severity(angle + 0.1, angle + 0.2), Severity::error);
}

TEST(Gates, AFlatTetIsToldWithItsFigureComponentMaterialAndPaintedVertex) {
    TetMesh mesh = squashed(0.02);
    mesh.region.assign(mesh.tets.size(), 0);
    const std::vector<std::string> components{"body"};
    const std::vector<std::string> materials{"steel"};
    const std::vector<std::uint16_t> tet_material(mesh.tets.size(), 0);
    const std::vector<Vec3> painted{{1, 1, 1}, {0.25, 0, 0}};
    const std::vector<Finding> findings = judged(mesh, {}, {components, materials, tet_material, painted});
    const Finding* finding = find(findings, "GATE_MIN_DIHEDRAL");
    ASSERT_TRUE(finding);
    ASSERT_FALSE(finding->places.empty());
    const Place& place = finding->places.front();
    EXPECT_NE(place.name.find("degrees, body, steel, "), std::string::npos) << place.name;
    EXPECT_NE(place.name.find("painted vertex at (0.25 0 0)"), std::string::npos) << place.name;
    EXPECT_LT(place.position.x, 0.5);
    EXPECT_NE(finding->message.find("try "), std::string::npos) << finding->message;
}

TEST(Gates, ThinTetsAreNotCountedAmongThoseBelowTenDegrees) {
    Figures figures = measure(shapes::tet_grid(2), nullptr);
    const TetMesh mesh = shapes::tet_grid(2);
    figures.shape.below_10_deg = 10;
    figures.below_10_thin = 10;
    EXPECT_EQ(find(judge(figures, mesh, nullptr), "GATE_BELOW_10_DEG"), nullptr);
    figures.below_10_thin = 0;
    const std::vector<Finding> findings = judge(figures, mesh, nullptr);
    ASSERT_TRUE(find(findings, "GATE_BELOW_10_DEG"));
    EXPECT_EQ(find(findings, "GATE_BELOW_10_DEG")->severity, Severity::error) << "10 of 48 is more than 5 %";
    EXPECT_EQ(find(findings, "GATE_BELOW_10_DEG")->count, 10u);
}

TEST(Gates, LostVolumeAndStrayingSurfacesAreToldByPlace) {
    const TetMesh mesh = shapes::tet_grid(2);
    Figures figures = measure(mesh, nullptr);
    figures.fidelity = {true, true, -0.084, 0.025, 0.055, 0, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Finding> findings = judge(figures, mesh, nullptr);
    ASSERT_TRUE(find(findings, "GATE_VOLUME"));
    EXPECT_EQ(find(findings, "GATE_VOLUME")->severity, Severity::error);
    EXPECT_NE(find(findings, "GATE_VOLUME")->message.find("lost"), std::string::npos);
    EXPECT_EQ(find(findings, "GATE_VOLUME")->places.at(0).position, (Vec3{0, 1, 0}));
    EXPECT_EQ(find(findings, "GATE_HAUSDORFF_OUT")->severity, Severity::warning);
    EXPECT_EQ(find(findings, "GATE_HAUSDORFF_IN")->severity, Severity::error);
    figures.fidelity.is_closed = false;
    EXPECT_EQ(find(judge(figures, mesh, nullptr), "GATE_HAUSDORFF_IN"), nullptr) << "open shells have no distance";
    figures.fidelity.is_known = false;
    EXPECT_TRUE(judge(figures, mesh, nullptr).empty());
}

TEST(Gates, TouchingCubesAreNonManifoldAndTwoPieces) {
    TetMesh mesh = shapes::tet_grid(2);
    // Two cells that share an edge only.
    std::erase_if(mesh.tets, [&](const Tet& tet) {
        Vec3 centre;
        for (const Index v : tet) centre += mesh.positions[v] * 0.25;
        const bool low = centre.x < 0.5 && centre.y < 0.5 && centre.z < 0.5;
        const bool high = centre.x > 0.5 && centre.y > 0.5 && centre.z < 0.5;
        return !low && !high;
    });
    mesh.neighbours = neighbours_of(mesh.tets);
    Figures figures = measure(mesh, nullptr);
    EXPECT_EQ(figures.topology.non_manifold_edges, 1u);
    EXPECT_EQ(figures.topology.non_manifold_vertices, 2u);
    EXPECT_EQ(figures.topology.pieces, 2u);
    figures.topology.shell_pieces = 1;
    const std::vector<Finding> findings = judge(figures, mesh, nullptr);
    ASSERT_TRUE(find(findings, "GATE_NON_MANIFOLD"));
    EXPECT_EQ(find(findings, "GATE_NON_MANIFOLD")->severity, Severity::warning);
    EXPECT_EQ(find(findings, "GATE_NON_MANIFOLD")->places.size(), 2u);
    ASSERT_TRUE(find(findings, "GATE_PIECES"));
    EXPECT_EQ(find(findings, "GATE_PIECES")->severity, Severity::error);
    EXPECT_NE(find(findings, "GATE_PIECES")->places.at(0).name.find("6 tets"), std::string::npos);
    figures.topology.shell_pieces = 2;
    EXPECT_EQ(find(judge(figures, mesh, nullptr), "GATE_PIECES"), nullptr);
}

TEST(Gates, BadlyHungVerticesAreWarnedOf) {
    const TetMesh mesh = shapes::tet_grid(2);
    Figures figures = measure(mesh, nullptr);
    figures.embedding = {1000, 50, 3.5, 2};
    EmbeddingResult embedding;
    embedding.wrong = {{{{1, 2, 3}, 7, "wheel"}, 0}};
    const std::vector<Finding> findings = judge(figures, mesh, nullptr, {}, {}, &embedding);
    ASSERT_EQ(findings.size(), 3u);
    EXPECT_EQ(find(findings, "GATE_OUTSIDE")->count, 50u);
    EXPECT_EQ(find(findings, "GATE_MAX_WEIGHT")->severity, Severity::warning);
    EXPECT_EQ(find(findings, "GATE_BOUND_WRONGLY")->places.at(0).name, "wheel");
}

TEST(Gates, ABadlyHungVertexIsToldByTheTetItHangsOn) {
    TetMesh mesh = shapes::tet_grid(2);
    mesh.region.assign(mesh.tets.size(), 0);
    mesh.region[5] = 1;
    Figures figures = measure(mesh, nullptr);
    figures.embedding = {10, 5, 3.5, 1};
    EmbeddingResult embedding;
    embedding.wrong = {{{{1, 2, 3}, 7, "wheel"}, 5}};
    embedding.heaviest = {{{{0, 0, 1}, 8, "paint, weight 3.5"}, 0}};
    const std::vector<std::string> components{"body", "engine"};
    const std::vector<std::string> materials{"steel"};
    const std::vector<std::uint16_t> tet_material(mesh.tets.size(), 0);
    const std::vector<Vec3> painted{{0, 0, 0}};
    const std::vector<Finding> findings =
        judge(figures, mesh, nullptr, {}, {components, materials, tet_material, painted}, &embedding);
    const Place& wrong = find(findings, "GATE_BOUND_WRONGLY")->places.at(0);
    EXPECT_EQ(wrong.position, (Vec3{1, 2, 3}));
    EXPECT_EQ(wrong.element, 7u);
    EXPECT_EQ(wrong.name, "wheel, engine, steel, 3.74 m from the painted vertex at (0 0 0)");
    for (const char* code : {"GATE_OUTSIDE", "GATE_MAX_WEIGHT"}) {
        EXPECT_EQ(find(findings, code)->places.at(0).name,
                  "paint, weight 3.5, body, steel, 1 m from the painted vertex at (0 0 0)");
    }
}

TEST(Gates, ALeakIsToldByTheShellsHolesTheWidestFirst) {
    const TetMesh mesh = shapes::tet_grid(2);
    Shell shell = shapes::subdivided_box(4);
    const auto middle_of = [&](const Triangle& t) {
        return (shell.positions[t[0]] + shell.positions[t[1]] + shell.positions[t[2]]) / 3.0;
    };
    // A whole side, and one triangle of the opposite one.
    std::erase_if(shell.triangles, [&](const Triangle& t) { return middle_of(t).x == 1; });
    shell.triangles.erase(std::find_if(shell.triangles.begin(), shell.triangles.end(),
                                       [&](const Triangle& t) { return middle_of(t).x == 0; }));
    Figures figures = measure(mesh, nullptr);
    figures.fidelity.is_known = true;
    figures.fidelity.leak_share = 0.5;
    const std::vector<Finding> findings = judge(figures, mesh, &shell);
    ASSERT_EQ(findings.size(), 1u);
    ASSERT_EQ(findings[0].places.size(), 2u);
    EXPECT_EQ(findings[0].places[0].position, (Vec3{1, 0.5, 0.5}));
    EXPECT_EQ(findings[0].places[0].name, "a hole 1.41 m across");
    EXPECT_EQ(findings[0].places[1].position.x, 0);
}

TEST(Gates, DoNotDependOnTheOrderOfTets) {
    TetMesh mesh = uneven_grid(4, 0.2);
    Limits strict;
    strict.min_dihedral_deg = {90, 90};
    const std::vector<Finding> findings = judged(mesh, strict);
    std::reverse(mesh.tets.begin(), mesh.tets.end());
    mesh.neighbours = neighbours_of(mesh.tets);
    const std::vector<Finding> reversed = judged(mesh, strict);
    ASSERT_EQ(findings.size(), reversed.size());
    const Finding* a = find(findings, "GATE_MIN_DIHEDRAL");
    const Finding* b = find(reversed, "GATE_MIN_DIHEDRAL");
    EXPECT_EQ(a->message, b->message);
    ASSERT_EQ(a->places.size(), max_places);
    for (std::size_t i = 0; i < max_places; ++i) {
        EXPECT_EQ(a->places[i].position, b->places[i].position);
        EXPECT_EQ(a->places[i].name, b->places[i].name);
    }
}

TEST(Baseline, EqualFiguresPass) {
    const Figures figures = measure(shapes::tet_grid(3), nullptr);
    EXPECT_TRUE(judge_against(baseline_of(figures), figures).empty());
    EXPECT_TRUE(judge_against({}, figures).empty()) << "an empty baseline compares nothing";
}

TEST(Baseline, MoreIterationsWarnThenFail) {
    const Figures figures = measure(shapes::tet_grid(3), nullptr);
    Figures worse = figures;
    worse.cost.pcg_stiff = figures.cost.pcg_stiff * 14 / 10;
    std::vector<Finding> findings = judge_against(baseline_of(figures), worse);
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].code, "GATE_PCG_STIFF");
    EXPECT_EQ(findings[0].severity, Severity::warning);
    worse.cost.pcg_stiff = figures.cost.pcg_stiff * 2;
    EXPECT_EQ(judge_against(baseline_of(figures), worse)[0].severity, Severity::error);
}

TEST(Baseline, AChangedVolumeIsTold) {
    const Figures figures = measure(shapes::tet_grid(3), nullptr);
    Figures changed = figures;
    changed.shape.volume *= 0.98;
    EXPECT_EQ(judge_against(baseline_of(figures), changed).at(0).code, "GATE_VOLUME_CHANGED");
}

}
