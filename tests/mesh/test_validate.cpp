// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "mesh/shapes.h"

namespace crumple {
namespace {

bool has(const std::vector<Finding>& findings, const std::string& code) {
    return std::any_of(findings.begin(), findings.end(),
                       [&](const Finding& f) { return f.code == code && f.count > 0; });
}

TEST(Validate, ShapesAreValid) {
    EXPECT_TRUE(validate(Shell{}).empty());
    EXPECT_TRUE(validate(TetMesh{}).empty());
    for (const Shell& shell : {shapes::tetrahedron(), shapes::subdivided_box(3), shapes::icosphere(), shapes::torus(),
                               shapes::thin_plate(), shapes::nested_boxes(), shapes::without_triangle(shapes::box())}) {
        const auto findings = validate(shell);
        EXPECT_TRUE(findings.empty()) << shell.components[0].name << ": " << findings[0].code;
    }
    EXPECT_TRUE(validate(shapes::tet_grid(2)).empty());
}

TEST(Validate, NamesEveryWayAShellCanBeWrong) {
    Shell shell = shapes::nested_boxes();
    shell.positions[3].y = std::numeric_limits<double>::quiet_NaN();
    shell.positions[4].y = 0.1;  // not a float
    shell.triangles[0][1] = 99;
    shell.triangles[1][0] = shell.triangles[1][1];
    shell.component[2] = 7;
    shell.components[1].name = shell.components[0].name;
    shell.components[0].parent = 0;
    shell.locked.pop_back();
    shell.color.resize(1);
    const auto findings = validate(shell);
    for (const char* code : {"SHELL_POSITION", "SHELL_CORNERS", "SHELL_COMPONENT_INDEX", "SHELL_COMPONENT_NAME",
                             "SHELL_COMPONENT_PARENT", "SHELL_SIZES"}) {
        EXPECT_TRUE(has(findings, code)) << code;
    }
    EXPECT_EQ(findings[0].count, 2u);
    EXPECT_EQ(findings[0].places[0].element, 3u);
}

TEST(Validate, NamesEveryWayTetsCanBeWrong) {
    TetMesh mesh = shapes::tet_grid(1);
    mesh.neighbours[0][0] = 5;
    EXPECT_TRUE(has(validate(mesh), "TETS_NEIGHBOURS"));
    mesh.region.assign(6, 2);
    EXPECT_TRUE(has(validate(mesh, 2), "TETS_REGION"));
    EXPECT_FALSE(has(validate(mesh, 3), "TETS_REGION"));
    std::swap(mesh.tets[1][0], mesh.tets[1][1]);
    EXPECT_TRUE(has(validate(mesh), "TETS_ORIENTATION"));
    mesh.tets[2][3] = 8;
    EXPECT_TRUE(has(validate(mesh), "TETS_CORNERS"));
    mesh.shell_vertex_count = 9;
    EXPECT_TRUE(has(validate(mesh), "TETS_SIZES"));
}

TEST(Validate, ThreeTetsOnOneFaceAreRefused) {
    TetMesh mesh = shapes::tet_grid(1);
    mesh.tets.assign(3, mesh.tets[0]);
    EXPECT_TRUE(has(validate(mesh), "TETS_FACES"));
}

}
}
