// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/crossings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"
#include "delaunay/delaunay.h"
#include "mesh/shapes.h"
#include "recover/constraints.h"

using namespace crumple;
using namespace crumple::recover;

namespace {

PointSet random_points(int count, std::uint64_t seed) {
    Rng random(seed);
    PointSet points;
    for (int i = 0; i < count; ++i) {
        const double x = random.next_unit();
        const double y = random.next_unit();
        const double z = random.next_unit();
        points.positions.push_back(round_to_float({x, y, z}));
    }
    return points;
}

std::vector<Crossing> crossings_between(const TetComplex& complex, Index a, Index b) {
    std::vector<Crossing> crossings;
    crossings_of_segment(complex, a, b, crossings);
    return crossings;
}

TEST(Crossings, AnEdgeHasNone) {
    const TetMesh mesh = shapes::tet_grid(2);
    const TetComplex complex(mesh);
    EXPECT_TRUE(crossings_between(complex, mesh.tets[0][0], mesh.tets[0][3]).empty());
}

TEST(Crossings, TheOtherDiagonalOfASquareCrossesOneEdge) {
    const TetMesh mesh = shapes::tet_grid(1);
    const TetComplex complex(mesh);
    std::size_t squares = 0;
    for (Index a = 0; a < 8; ++a) {
        for (Index b = 0; b < a; ++b) {
            const Vec3 d = complex.position(a) - complex.position(b);
            if (dot(d, d) != 2 || complex.find_edge(a, b) != none) continue;
            ++squares;
            const std::vector<Crossing> crossings = crossings_between(complex, a, b);
            ASSERT_EQ(crossings.size(), 1u);
            EXPECT_EQ(crossings[0].count, 2);
        }
    }
    EXPECT_EQ(squares, 6u);
}

TEST(Crossings, ANodeInTheWayEndsTheWalk) {
    const TetMesh mesh = shapes::tet_grid(2);  // 27 nodes, x slowest
    const TetComplex complex(mesh);
    const std::vector<Crossing> crossings = crossings_between(complex, 0, 26);
    ASSERT_FALSE(crossings.empty());
    EXPECT_EQ(crossings.back().count, 1);
    EXPECT_EQ(crossings.back().nodes[0], 13u);
}

TEST(Crossings, TheWalkMeetsTheFacesThatBruteForceFinds) {
    const TetMesh mesh = delaunay::tetrahedralize(random_points(60, 3)).mesh;
    const TetComplex complex(mesh);
    for (Index a = 0; a < 60; a += 7) {
        for (Index b = 0; b < 60; b += 5) {
            if (a == b) continue;
            std::vector<Triangle> expected;
            for (Index t = 0; t < mesh.tets.size(); ++t) {
                for (int corner = 0; corner < 4; ++corner) {
                    if (mesh.neighbours[t][corner] != none && mesh.neighbours[t][corner] < t) continue;
                    const auto& f = tet_face_corners[corner];
                    const Triangle face = sorted_triangle(mesh.tets[t][f[0]], mesh.tets[t][f[1]], mesh.tets[t][f[2]]);
                    if (pierces(mesh.positions[a], mesh.positions[b], mesh.positions[face[0]], mesh.positions[face[1]],
                                mesh.positions[face[2]])) {
                        expected.push_back(face);
                    }
                }
            }
            std::vector<Triangle> found;
            for (const Crossing& c : crossings_between(complex, a, b)) {
                ASSERT_EQ(c.count, 3) << "points in general position";
                found.push_back(sorted_triangle(c.nodes[0], c.nodes[1], c.nodes[2]));
            }
            std::sort(expected.begin(), expected.end());
            std::sort(found.begin(), found.end());
            EXPECT_EQ(found, expected);
        }
    }
}

TEST(Crossings, EveryWalkThroughACosphericalGridArrives) {
    const TetMesh mesh = delaunay::tetrahedralize(shapes::grid_points(4)).mesh;
    const TetComplex complex(mesh);
    for (Index a = 0; a < 64; ++a) {
        for (Index b = 0; b < 64; ++b) {
            if (a == b) continue;
            for (const Crossing& c : crossings_between(complex, a, b)) {
                EXPECT_GT(c.count, 0);
                for (int i = 0; i < c.count; ++i) EXPECT_GE(complex.corner_of(c.tet, c.nodes[i]), 0);
            }
        }
    }
}

TEST(Crossings, ObstaclesOfAFacetAreTheEdgesThatBruteForceFinds) {
    const TetMesh mesh = delaunay::tetrahedralize(random_points(40, 5)).mesh;
    const TetComplex complex(mesh);
    std::vector<Edge> edges;
    for (const Tet& tet : mesh.tets) {
        for (const auto& [i, j] : tet_edge_corners) edges.push_back(sorted_edge(tet[i], tet[j]));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    FacetObstacles obstacles;
    for (Index a = 0; a + 2 < 40; ++a) {
        const Triangle facet{a, (a * 7 + 1) % 40, (a * 11 + 2) % 40};
        if (facet[0] == facet[1] || facet[1] == facet[2] || facet[2] == facet[0]) continue;
        std::vector<Edge> expected;
        for (const Edge& e : edges) {
            if (pierces(mesh.positions[e[0]], mesh.positions[e[1]], mesh.positions[facet[0]], mesh.positions[facet[1]],
                        mesh.positions[facet[2]])) {
                expected.push_back(e);
            }
        }
        obstacles_of_any_facet(complex, facet, obstacles);
        std::vector<Edge> found;
        for (const PiercingEdge& edge : obstacles.edges) found.push_back(edge.nodes);
        std::sort(found.begin(), found.end());
        EXPECT_EQ(found, expected);
        EXPECT_EQ(obstacles.node, none);
    }
}

TEST(Crossings, SegmentsOfOnePlaneCrossOnlyInsideBoth) {
    EXPECT_TRUE(segments_cross({0, 0, 0}, {2, 2, 0}, {0, 2, 0}, {2, 0, 0}));
    EXPECT_FALSE(segments_cross({0, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0})) << "ends on it";
    EXPECT_FALSE(segments_cross({0, 0, 0}, {2, 2, 0}, {0, 2, 1}, {2, 0, 0})) << "off the plane";
    EXPECT_FALSE(segments_cross({0, 0, 0}, {2, 2, 0}, {1, 1, 0}, {3, 3, 0})) << "along it";
    EXPECT_FALSE(segments_cross({0, 0, 0}, {1, 1, 0}, {0, 4, 0}, {4, 0, 0})) << "short of it";
}

}
