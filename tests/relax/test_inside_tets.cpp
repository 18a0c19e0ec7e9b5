// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/inside_tets.h"

#include <gtest/gtest.h>

#include "filled_shell.h"
#include "mesh/shapes.h"

using namespace crumple;
using namespace crumple::relax;

namespace {

void expect_true_answers(InsideTets& inside, const TetMesh& mesh, const ShellInterior& truth) {
    const std::vector<std::uint8_t> found = inside.find(mesh, {});
    ASSERT_EQ(found.size(), mesh.tets.size());
    for (std::size_t t = 0; t < found.size(); ++t) {
        Vec3 sum;
        for (const Index v : mesh.tets[t]) sum += mesh.positions[v];
        EXPECT_EQ(found[t] != 0, truth.material_at(sum * 0.25) != none) << t;
    }
}

TEST(InsideTets, AnEmptyMeshHasNone) {
    const ShellInterior interior(shapes::box());
    InsideTets inside(interior);
    EXPECT_TRUE(inside.find({}, {}).empty());
}

TEST(InsideTets, CentresDecideThoughNodesAreInside) {
    // The hole of a torus is bridged by tets of which some have interior nodes.
    const Shell shell = shapes::torus();
    const ShellInterior interior(shell);
    InsideTets inside(interior);
    expect_true_answers(inside, shapes::filled(shell, "200"), interior);
}

TEST(InsideTets, WhatIsRememberedStaysTrueForOtherInteriorNodes) {
    const Shell shell = shapes::nested_boxes();
    const ShellInterior interior(shell);
    InsideTets inside(interior);
    const TetMesh one = shapes::filled(shapes::nested_boxes(), "20");
    expect_true_answers(inside, one, interior);
    PointSet points{shell.positions, static_cast<Index>(shell.positions.size())};
    for (const Vec3 p : {Vec3{0.5, 0.5, 0.5}, Vec3{2.5, 2.5, 0.25}, Vec3{0.25, 2.75, 1.5}})
        points.positions.push_back(p);
    expect_true_answers(inside, delaunay::tetrahedralize(points).mesh, interior);
    expect_true_answers(inside, one, interior);
}

}
