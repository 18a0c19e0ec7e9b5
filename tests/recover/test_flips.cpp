// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/flips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "delaunay/delaunay.h"
#include "exact_volume.h"
#include "mesh/shapes.h"
#include "mesh/validate.h"

using namespace crumple;
using namespace crumple::recover;

namespace {

// Nodes 0 and 1 on the y axis, n others in a ring around it: n tets around the edge (0, 1).
TetMesh bipyramid(int n, double height = 1) {
    PointSet points;
    points.positions = {{0, -height, 0}, {0, height, 0}};
    TetMesh mesh;
    for (int i = 0; i < n; ++i) {
        const double angle = -2 * std::numbers::pi * i / n;
        points.positions.push_back(round_to_float({std::cos(angle), 0.01 * (i % 3), std::sin(angle)}));
    }
    mesh.positions = points.positions;
    for (Index i = 0; i < static_cast<Index>(n); ++i) mesh.tets.push_back({0, 1, 2 + i, 2 + (i + 1) % n});
    mesh.neighbours.assign(n, {none, none, none, none});
    for (int i = 0; i < n; ++i) {
        mesh.neighbours[i][2] = (i + 1) % n;
        mesh.neighbours[i][3] = (i + n - 1) % n;
    }
    return mesh;
}

std::vector<Tet> sorted_tets(const TetComplex& complex) {
    std::vector<Tet> tets = complex.to_mesh().tets;
    for (Tet& tet : tets) std::sort(tet.begin(), tet.end());
    std::sort(tets.begin(), tets.end());
    return tets;
}

class Rings : public testing::TestWithParam<int> {};

TEST_P(Rings, TheMiddleEdgeGoesAndTheVolumeStays) {
    const TetMesh mesh = bipyramid(GetParam());
    ASSERT_TRUE(validate(mesh).empty());
    TetComplex complex(mesh);
    const Constraints constraints;
    Flips flips(complex, constraints);
    Exchange exchange;
    ASSERT_TRUE(flips.plan_edge_removal({}, 0, 0, 1, exchange));
    EXPECT_EQ(exchange.fresh.size(), 2u * (GetParam() - 2));
    flips.apply(exchange);
    EXPECT_EQ(complex.find_edge(0, 1), none);
    EXPECT_TRUE(validate(complex.to_mesh()).empty());
    EXPECT_EQ(exact_six_volumes(complex.to_mesh()), exact_six_volumes(mesh));
    flips.roll_back(0);
    EXPECT_EQ(sorted_tets(complex), sorted_tets(TetComplex(mesh)));
    EXPECT_EQ(flips.count(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Rings, testing::Values(3, 4, 5, 8, 12), testing::PrintToStringParamName());

TEST(Flips, ASegmentIsNeverTakenOut) {
    TetComplex complex(bipyramid(4));
    Constraints constraints;
    constraints.add_facet({0, 1, 2}, 0);
    Flips flips(complex, constraints);
    Exchange exchange;
    EXPECT_FALSE(flips.plan_edge_removal({}, 0, 0, 1, exchange));
    flips.set_budget(10);
    EXPECT_FALSE(flips.clear_edge(0, 1, 3));
}

TEST(Flips, AFacetIsNeverTakenOut) {
    TetMesh mesh = bipyramid(4);
    TetComplex complex(mesh);
    Constraints constraints;
    const Tet first = complex.corners(0);
    const Index other = complex.neighbour(0, 2);
    ASSERT_NE(other, none);
    constraints.add_facet({first[0], first[1], first[3]}, 0);
    Flips flips(complex, constraints);
    Exchange exchange;
    EXPECT_FALSE(flips.plan_face_removal({}, 0, 2, exchange));
}

TEST(Flips, AFaceGivesWayToTheEdgeThroughIt) {
    const TetMesh mesh = [] {
        TetMesh two;
        two.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 1}, {0.25, 0.25, -1}};
        two.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
        two.neighbours = {{none, none, none, 1}, {none, none, none, 0}};
        return two;
    }();
    TetComplex complex(mesh);
    const Constraints constraints;
    Flips flips(complex, constraints);
    Exchange exchange;
    ASSERT_TRUE(flips.plan_face_removal({3, 4, none}, 0, 3, exchange));
    EXPECT_EQ(exchange.gain, 1);
    flips.apply(exchange);
    EXPECT_NE(complex.find_edge(3, 4), none);
    EXPECT_TRUE(validate(complex.to_mesh()).empty());
    EXPECT_EQ(exact_six_volumes(complex.to_mesh()), exact_six_volumes(mesh));
}

TEST(Flips, AFaceThatTheApexesDoNotSeeEachOtherThroughStays) {
    TetMesh two;
    two.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.9, 0.9, 1}, {0.9, 0.9, -1}};
    two.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
    two.neighbours = {{none, none, none, 1}, {none, none, none, 0}};
    TetComplex complex(two);
    const Constraints constraints;
    Flips flips(complex, constraints);
    Exchange exchange;
    EXPECT_FALSE(flips.plan_face_removal({}, 0, 3, exchange));
}

TEST(Flips, OnTheHullAnEdgeGoesOnlyBetweenCoplanarFaces) {
    const TetMesh mesh = shapes::tet_grid(1);
    TetComplex complex(mesh);
    const Constraints constraints;
    Flips flips(complex, constraints);
    Exchange exchange;
    const std::string volume = exact_six_volumes(mesh);
    int done = 0;
    for (Index a = 0; a < 8; ++a) {
        for (Index b = 0; b < a; ++b) {
            const Index tet = complex.find_edge(a, b);
            if (tet == none || !flips.plan_edge_removal({}, tet, a, b, exchange)) continue;
            const Vec3 d = complex.position(a) - complex.position(b);
            EXPECT_EQ(dot(d, d), 2) << "the edges of the cube stay";
            flips.apply(exchange);
            ++done;
            EXPECT_TRUE(validate(complex.to_mesh()).empty());
            EXPECT_EQ(exact_six_volumes(complex.to_mesh()), volume);
            flips.roll_back(0);
        }
    }
    EXPECT_GT(done, 0);
}

TEST(Flips, ClearingAnEdgeThatCannotGoChangesNothing) {
    const TetMesh mesh = delaunay::tetrahedralize(shapes::points_of(shapes::icosphere(1, 1))).mesh;
    TetComplex complex(mesh);
    const Constraints constraints;
    Flips flips(complex, constraints);
    const std::vector<Tet> before = sorted_tets(complex);
    for (const auto& [i, j] : tet_edge_corners) {
        const Tet tet = complex.corners(0);
        flips.set_budget(50);
        if (!flips.clear_edge(tet[i], tet[j], 3)) {
            EXPECT_EQ(sorted_tets(complex), before);
        }
        EXPECT_TRUE(validate(complex.to_mesh()).empty());
        flips.roll_back(0);
        EXPECT_EQ(sorted_tets(complex), before);
    }
}

TEST(Flips, QualityIsOneForARegularTet) {
    TetMesh mesh;
    mesh.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    mesh.tets = {{0, 2, 1, 3}};
    mesh.neighbours = {{none, none, none, none}};
    EXPECT_NEAR(std::fabs(quality_of(TetComplex(mesh), mesh.tets[0])), 1, 1e-12);
}

}
