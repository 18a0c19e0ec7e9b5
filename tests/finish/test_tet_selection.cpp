// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/tet_selection.h"

#include <gtest/gtest.h>

#include "finish/open_space.h"
#include "mesh/shapes.h"
#include "small_meshes.h"

namespace crumple::finish {
namespace {

void expect_same(const TetMesh& a, const TetMesh& b) {
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.tets, b.tets);
    EXPECT_EQ(a.neighbours, b.neighbours);
}

TEST(TetSelection, WhatIsPutCanBeTakenBack) {
    const TetMesh mesh = small::ring(5, 1);
    SurfaceChange removal;
    removal.gone = {1, 3};
    SurfaceChange split;
    split.split_node = 0;
    split.split_tets = {0, 2};
    for (const SurfaceChange& change : {removal, split}) {
        TetSelection tets(mesh);
        tets.put(change);
        EXPECT_FALSE(change.is_empty());
        tets.take_back(change);
        for (Index v = 0; v < mesh.positions.size(); ++v) EXPECT_TRUE(tets.is_manifold(v));
        expect_same(std::move(tets).take(), mesh);
    }
}

TEST(TetSelection, KnowsManifoldNodesAsBoundaryDoes) {
    const TetMesh mesh = shapes::tet_grid(2);
    for (Index seed = 1; seed < 40; ++seed) {
        TetSelection tets(mesh);
        SurfaceChange change;
        for (Index t = 0; t < mesh.tets.size(); ++t) {
            if ((t * 2654435761u + seed * 40503u) % 3 == 0) change.gone.push_back(t);
        }
        tets.put(change);
        std::vector<Index> wrong;
        for (Index v = 0; v < mesh.positions.size(); ++v) {
            if (!tets.is_manifold(v)) wrong.push_back(v);
        }
        const TetMesh left = std::move(tets).take();
        EXPECT_EQ(wrong, non_manifold(boundary_of(left).faces).vertices) << seed;
    }
}

TEST(TetSelection, PartsAreWhatFacesConnect) {
    TetMesh mesh = small::ring(6, 1);
    TetSelection tets(mesh);
    EXPECT_EQ(tets.parts_at(0, none).size(), 1u);
    SurfaceChange change;
    change.gone = {1, 4};
    tets.put(change);
    EXPECT_EQ(tets.parts_at(0, none).size(), 2u);
    EXPECT_EQ(tets.parts_at(0, 1).size(), 2u);
    EXPECT_EQ(tets.parts_at(2, none).size(), 1u);
}

TEST(OpenSpace, ThereIsRoomInANotchAndNoneInside) {
    // A ring of eight without two neighbouring tets.
    TetMesh mesh = small::ring(8, 1);
    const Tet first = mesh.tets[0];
    const Tet second = mesh.tets[1];
    mesh.tets.erase(mesh.tets.begin(), mesh.tets.begin() + 2);
    mesh.neighbours = neighbours_of(mesh.tets);
    const std::vector<Triangle> faces = boundary_of(mesh).faces;
    const OpenSpace space(mesh.positions, faces);
    EXPECT_TRUE(space.has_room_for(mesh.positions, first, {}));
    EXPECT_TRUE(space.has_room_for(mesh.positions, second, std::span(&first, 1)));
    EXPECT_FALSE(space.has_room_for(mesh.positions, second, std::span(&second, 1))) << "it is there already";
    // Across the whole ring: runs into the others.
    EXPECT_FALSE(space.has_room_for(mesh.positions, {0, 1, 2, 7}, {}));
    EXPECT_FALSE(space.has_room_for(mesh.positions, {first[1], first[0], first[2], first[3]}, {})) << "inside out";
}

}
}
