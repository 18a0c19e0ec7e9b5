// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary.h"

#include <gtest/gtest.h>

#include "geometry/measures.h"
#include "mesh/neighbours.h"
#include "mesh/shapes.h"

namespace crumple {
namespace {

// The tets of a 2^3 grid whose cube (numbered x slowest) is in `cubes`.
TetMesh cubes_of_grid(std::initializer_list<Index> cubes) {
    TetMesh mesh = shapes::tet_grid(2);
    std::vector<Tet> kept;
    for (const Index cube : cubes)
        kept.insert(kept.end(), mesh.tets.begin() + 6 * cube, mesh.tets.begin() + 6 * cube + 6);
    mesh.tets = kept;
    mesh.neighbours = neighbours_of(mesh.tets);
    return mesh;
}

TEST(Boundary, OfNothingIsNothing) {
    EXPECT_TRUE(boundary_of(TetMesh{}).faces.empty());
    EXPECT_TRUE(non_manifold({}).edges.empty());
    EXPECT_TRUE(pieces_of(TetMesh{}).empty());
}

TEST(Boundary, OfACubeIsClosedAndFacesOutwards) {
    const TetMesh mesh = shapes::tet_grid(3);
    const Boundary boundary = boundary_of(mesh);
    EXPECT_EQ(boundary.faces.size(), 108u);
    double volume = 0;
    for (const auto& [a, b, c] : boundary.faces) {
        volume += signed_volume({}, mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    }
    EXPECT_NEAR(volume, 1, 1e-6);
    const NonManifold wrong = non_manifold(boundary.faces);
    EXPECT_TRUE(wrong.edges.empty());
    EXPECT_TRUE(wrong.vertices.empty());
    EXPECT_EQ(pieces_of(mesh), std::vector<Index>(162, 0));
}

TEST(Boundary, CubesThatShareAnEdgeAreNotManifoldThere) {
    const TetMesh mesh = cubes_of_grid({0, 3});  // (0,0,0) and (0,1,1): the edge along x in the middle
    const NonManifold wrong = non_manifold(boundary_of(mesh).faces);
    ASSERT_EQ(wrong.edges.size(), 1u);
    EXPECT_EQ(wrong.edges[0], (Edge{4, 13}));
    EXPECT_EQ(wrong.vertices, (std::vector<Index>{4, 13}));
    EXPECT_EQ(pieces_of(mesh).back(), 1u);
}

TEST(Boundary, CubesThatShareACornerAreNotManifoldThere) {
    const NonManifold wrong = non_manifold(boundary_of(cubes_of_grid({0, 7})).faces);
    EXPECT_TRUE(wrong.edges.empty());
    EXPECT_EQ(wrong.vertices, std::vector<Index>{13});
}

TEST(Boundary, AnOpenSurfaceIsNotManifoldAtItsRim) {
    const Shell shell = shapes::without_triangle(shapes::icosphere());
    const NonManifold wrong = non_manifold(shell.triangles);
    EXPECT_EQ(wrong.edges.size(), 3u);
    EXPECT_EQ(wrong.vertices.size(), 3u);
}

}
}
