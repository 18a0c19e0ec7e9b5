// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/cavity.h"

#include <gtest/gtest.h>

#include "all_holders.h"
#include "exact_volume.h"
#include "mesh/shapes.h"
#include "mesh/validate.h"
#include "recover/constraints.h"
#include "recover/insert_node.h"

using namespace crumple;
using namespace crumple::recover;

namespace {

// The inner node of a grid of 2 cells an axis, and the tets around it.
constexpr Index middle_node = 13;

Cavity star_cavity(const TetComplex& complex) {
    Cavity cavity;
    complex.star_of(middle_node, cavity.tets);
    for (const Index t : cavity.tets)
        cavity.faces.push_back(outward_face(complex.corners(t), complex.corner_of(t, middle_node)));
    return cavity;
}

TEST(Cavity, AConvexStarIsFilledFromOneOfItsNodes) {
    const TetMesh mesh = shapes::tet_grid(2);
    TetComplex complex(mesh);
    const Cavity cavity = star_cavity(complex);
    const Filling filling = best_filling(complex, cavity, complex.position(middle_node));
    ASSERT_GT(filling.quality, 0);
    const Index apex = filling.node != none ? filling.node : complex.add_node(filling.place);
    std::vector<Tet> fresh;
    append_cone(cavity, apex, fresh);
    complex.replace(cavity.tets, fresh);
    EXPECT_EQ(complex.tet_at(middle_node), none);
    EXPECT_TRUE(validate(complex.to_mesh()).empty());
    EXPECT_EQ(exact_six_volumes(complex.to_mesh()), exact_six_volumes(mesh));
}

TEST(Cavity, ANodePutIntoTheTetsLeavesThemPositive) {
    const TetMesh mesh = shapes::tet_grid(3);
    TetComplex complex(mesh);
    const Constraints constraints;
    for (const Vec3 place : {Vec3{0.4, 0.45, 0.55}, Vec3{0.41, 0.52, 0.48}, Vec3{0.5, 0.5, 0.5}}) {
        const Vec3 rounded = round_to_float(place);
        const std::vector<Index> holders = all_holders(complex, rounded);
        ASSERT_FALSE(holders.empty());
        const Index node = insert_node(complex, constraints, rounded, holders);
        ASSERT_NE(node, none);
        EXPECT_NE(complex.tet_at(node), none);
        EXPECT_TRUE(validate(complex.to_mesh()).empty());
        EXPECT_EQ(exact_six_volumes(complex.to_mesh()), exact_six_volumes(mesh));
    }
}

TEST(Cavity, AFacetBoundsWhatANodeMayTakeAway) {
    const TetMesh mesh = shapes::tet_grid(3);
    TetComplex complex(mesh);
    Constraints constraints;
    for (Index f = 0; f < mesh.tets.size(); ++f) {
        const Triangle face = outward_face(mesh.tets[f], 0);
        constraints.add_facet(face, f);
    }
    const Vec3 place = round_to_float({0.41, 0.45, 0.52});
    ASSERT_NE(insert_node(complex, constraints, place, all_holders(complex, place)), none);
    for (const Triangle& t : constraints.facets()) EXPECT_NE(complex.find_face(t[0], t[1], t[2]), none);
    for (const Edge& e : constraints.segments()) EXPECT_NE(complex.find_edge(e[0], e[1]), none);
    EXPECT_TRUE(validate(complex.to_mesh()).empty());
}

TEST(Cavity, ANodeOnTheHullIsRefused) {
    TetComplex complex(shapes::tet_grid(2));
    const Vec3 place = round_to_float({0.3, 0.6, 0});
    EXPECT_EQ(insert_node(complex, {}, place, all_holders(complex, place)), none);
    EXPECT_TRUE(validate(complex.to_mesh()).empty());
}

}
