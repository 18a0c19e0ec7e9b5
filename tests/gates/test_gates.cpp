// SPDX-License-Identifier: GPL-3.0-or-later
#include "gates/gates.h"

#include <gtest/gtest.h>

#include "bake/grid_input.h"
#include "bundle/validate.h"
#include "gates/bundle_mesh.h"
#include "mesh/boundary.h"
#include "mesh/neighbours.h"

using namespace crumple;
using gates::Params;
using gates::Report;

namespace {

// A cube of good tets whose shell is its surface, floor locked, with a visual vertex in each tet, and its bundle.
struct Cooked {
    test::BakeInput input = test::grid_input(3, 0.0);
    Bundle bundle;

    Cooked() {
        TetMesh& mesh = input.mesh;
        mesh.neighbours = neighbours_of(mesh.tets);
        Shell& shell = input.asset.shell;
        shell.triangles = boundary_of(mesh).faces;
        shell.component.assign(shell.triangles.size(), 0);
        VisualMesh visual;
        visual.name = "paint";
        for (std::size_t v = 0; v < input.bindings[0].tet.size(); ++v) {
            Vec3 p;
            for (int i = 0; i < 4; ++i)
                p += mesh.positions[mesh.tets[input.bindings[0].tet[v]][i]] * input.bindings[0].barycentric[v][i];
            visual.positions.push_back(p);
        }
        input.asset.visuals.push_back(visual);
        bake();
    }
    void bake() { bundle = test::bake_input(input).bundle; }
    [[nodiscard]] Report judge(const Params& params = {}, const gates::Solid& solid = {}) const {
        return gates::judge_bundle(bundle, input.asset, solid, params);
    }
};

std::vector<std::string> codes_of(const std::vector<Finding>& findings) {
    std::vector<std::string> codes;
    for (const Finding& finding : findings) codes.push_back(finding.code);
    return codes;
}

const Finding* find(const Report& report, const std::string& code) {
    for (const Finding& finding : report.findings) {
        if (finding.code == code) return &finding;
    }
    return nullptr;
}

Params strict_about_angles() {
    Params params;
    params.limits.min_dihedral_deg.fail = 60;  // those of the grid have 45
    return params;
}

}

TEST(Gates, ABundleOfNothingIsJudgedWithoutACrash) { EXPECT_TRUE(gates::judge_again({}, {}).findings.empty()); }

TEST(Gates, AGoodBundlePassesAndItsFiguresAreTrue) {
    const Report report = Cooked().judge();
    EXPECT_TRUE(report.findings.empty()) << codes_of(report.findings)[0];
    const quality::Figures& f = report.figures;
    EXPECT_EQ(f.shape.tets, Cooked().bundle.tets.size());
    EXPECT_NEAR(f.shape.min_dihedral_deg, 45, 1e-4);
    EXPECT_TRUE(f.fidelity.is_known && f.fidelity.is_closed);
    EXPECT_NEAR(f.fidelity.volume_error, 0, 1e-6) << "positions are float";
    EXPECT_NEAR(f.fidelity.hausdorff_out, 0, 1e-6);
    EXPECT_EQ(f.topology.pieces, 1u);
    EXPECT_EQ(f.topology.shell_pieces, 1u);
    EXPECT_EQ(f.embedding.vertices, f.shape.tets);
    EXPECT_EQ(f.embedding.outside, 0u);
    EXPECT_GT(f.cost.pcg_stiff, 0u);
}

TEST(Gates, AFailingGateNamesComponentMaterialAndPaintedVertex) {
    const Report report = Cooked().judge(strict_about_angles());
    const Finding* finding = find(report, "GATE_MIN_DIHEDRAL");
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->severity, Severity::error);
    ASSERT_FALSE(finding->places.empty());
    EXPECT_NE(finding->places[0].name.find("body, steel"), std::string::npos) << finding->places[0].name;
    EXPECT_NE(finding->places[0].name.find("painted vertex"), std::string::npos) << finding->places[0].name;
}

TEST(Gates, WithoutEnforcingAFailureIsAWarning) {
    Params params = strict_about_angles();
    params.enforce = false;
    const Report report = Cooked().judge(params);
    const Finding* finding = find(report, "GATE_MIN_DIHEDRAL");
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->severity, Severity::warning);
}

TEST(Gates, WhatPassedPassesAgainWithoutTheAsset) {
    Cooked cooked;
    cooked.input.bindings[0].inside[0] = 0;
    cooked.input.bindings[0].distance[0] = 0.25;
    cooked.input.bindings[0].barycentric[0] = {2.5, -0.5, -0.5, -0.5};
    cooked.bake();
    ASSERT_TRUE(validate(cooked.bundle).empty());
    for (const Params& params : {Params(), strict_about_angles()}) {
        const Report told = cooked.judge(params);
        EXPECT_NE(find(told, "GATE_MAX_WEIGHT"), nullptr);
        const Report again = gates::judge_again(cooked.bundle, told, params);
        EXPECT_EQ(codes_of(again.findings), codes_of(told.findings));
        for (std::size_t i = 0; i < told.findings.size(); ++i) {
            EXPECT_EQ(again.findings[i].severity, told.findings[i].severity);
            EXPECT_EQ(again.findings[i].message, told.findings[i].message);
        }
        EXPECT_EQ(again.figures.cost.pcg_stiff, told.figures.cost.pcg_stiff);
        EXPECT_EQ(again.figures.cost.critical_step_m, told.figures.cost.critical_step_m);
        EXPECT_EQ(again.figures.embedding.outside, 1u);
        EXPECT_EQ(again.figures.fidelity.volume_error, told.figures.fidelity.volume_error);
    }
}

TEST(Gates, ABundleNobodyToldOfIsJudgedByItsTets) {
    const Cooked cooked;
    const Report report = gates::judge_again(cooked.bundle, {});
    EXPECT_FALSE(report.figures.fidelity.is_known);
    EXPECT_TRUE(report.findings.empty());
}

TEST(Gates, LostVolumeFails) {
    Cooked cooked;
    // The shell reaches 20 % higher than the tets.
    Shell& shell = cooked.input.asset.shell;
    for (Vec3& p : shell.positions) {
        if (p.y == 1) p.y = 1.25;
    }
    const Report report = cooked.judge();
    const Finding* finding = find(report, "GATE_VOLUME");
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->severity, Severity::error);
    EXPECT_NEAR(report.figures.fidelity.volume_error, -0.2, 1e-6);
    EXPECT_NE(find(report, "GATE_HAUSDORFF_IN"), nullptr);
}

TEST(Gates, AnOpenShellIsMeasuredAgainstWhatCullFound) {
    Cooked cooked;
    Shell& shell = cooked.input.asset.shell;
    shell.triangles.pop_back();
    shell.component.pop_back();
    const Report report = cooked.judge({}, {.volume = 2, .leak_share = 0.5, .pieces = 1});
    EXPECT_FALSE(report.figures.fidelity.is_closed);
    EXPECT_NEAR(report.figures.fidelity.volume_error, -0.5, 1e-6);
    EXPECT_NE(find(report, "GATE_LEAK"), nullptr);
    EXPECT_EQ(find(report, "GATE_HAUSDORFF_IN"), nullptr) << "it means nothing for an open shell";
}

TEST(Gates, AShellVertexThatTheBundleLacksIsStillThere) {
    Cooked cooked;
    Bundle& bundle = cooked.bundle;
    TetMesh mesh = gates::mesh_of(bundle);
    const std::size_t nodes = mesh.positions.size();
    Shell shell = cooked.input.asset.shell;
    shell.positions.push_back({5, 5, 5});
    bundle.mesh_to_node.resize(shell.positions.size() - 1);  // as if the mesh ended with the shell
    bundle.mesh_to_node.push_back(none);
    const Shell over = gates::shell_over(bundle, shell, mesh);
    EXPECT_EQ(mesh.positions.size(), nodes + 1);
    EXPECT_EQ(over.positions, mesh.positions);
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        for (int i = 0; i < 3; ++i)
            EXPECT_EQ(over.positions[over.triangles[f][i]], shell.positions[shell.triangles[f][i]]);
    }
}
