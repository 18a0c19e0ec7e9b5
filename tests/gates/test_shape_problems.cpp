// SPDX-License-Identifier: GPL-3.0-or-later
#include "gates/shape_problems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "mesh/shapes.h"

using namespace crumple;
using gates::find_problems;
using quality::summarize;

namespace {

std::set<std::string> codes_of(const std::vector<Finding>& findings) {
    std::set<std::string> codes;
    for (const Finding& finding : findings) codes.insert(finding.code);
    return codes;
}

std::vector<Finding> problems_of(const TetMesh& mesh) { return find_problems(mesh, summarize(mesh)); }

TEST(ShapeProblems, NoTetsHaveNone) { EXPECT_TRUE(problems_of({}).empty()); }

TEST(ShapeProblems, AGoodMeshHasNone) { EXPECT_TRUE(problems_of(shapes::tet_grid(3)).empty()); }

TEST(ShapeProblems, ASliverIsToldWithItsPlaceAndRemedy) {
    TetMesh mesh = shapes::tet_grid(2);
    const auto first = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{9.5, 0, 0}, {10.5, 0, 0}, {10, 0.5, 1e-3}, {10, -0.5, 1e-3}});
    mesh.tets.push_back({first, first + 1, first + 2, first + 3});
    const std::vector<Finding> findings = problems_of(mesh);
    const std::set<std::string> codes = codes_of(findings);
    for (const char* code : {"QUALITY_MIN_DIHEDRAL", "QUALITY_MAX_DIHEDRAL", "QUALITY_BELOW_10_DEG", "QUALITY_FLAT_TET",
                             "QUALITY_ELEMENT_STEP"}) {
        EXPECT_TRUE(codes.count(code)) << code;
    }
    EXPECT_FALSE(codes.count("QUALITY_INVERTED"));
    for (const Finding& finding : findings) {
        EXPECT_NE(finding.message.find("; "), std::string::npos) << finding.message;
        ASSERT_FALSE(finding.places.empty());
        EXPECT_LE(finding.places.size(), max_places);
        EXPECT_EQ(finding.places[0].element, mesh.tets.size() - 1);
        EXPECT_NEAR(finding.places[0].position.x, 10, 1e-9);
    }
}

TEST(ShapeProblems, InvertedTetsAreTheirOwnFinding) {
    TetMesh mesh = shapes::tet_grid(1);
    std::swap(mesh.tets[4][0], mesh.tets[4][1]);
    const std::vector<Finding> findings = problems_of(mesh);
    ASSERT_FALSE(findings.empty());
    EXPECT_EQ(findings[0].code, "QUALITY_INVERTED");
    EXPECT_EQ(findings[0].count, 1u);
    ASSERT_EQ(findings[0].places.size(), 1u);
    EXPECT_EQ(findings[0].places[0].element, 4u);
}

TEST(ShapeProblems, NoneIsAnErrorSinceNoGateWasAskedFor) {
    TetMesh mesh = shapes::tet_grid(1);
    std::swap(mesh.tets[4][0], mesh.tets[4][1]);
    for (const Finding& finding : problems_of(mesh)) EXPECT_EQ(finding.severity, Severity::warning);
}

}
