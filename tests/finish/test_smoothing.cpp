// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/smoothing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"
#include "finish/shape.h"
#include "small_meshes.h"

namespace crumple::finish {
namespace {

std::vector<OppositeFace> faces_around(const TetMesh& mesh, Index node) {
    std::vector<OppositeFace> faces;
    for (const Tet& tet : mesh.tets) {
        for (int corner = 0; corner < 4; ++corner) {
            if (tet[corner] != node) continue;
            const auto& face = tet_face_corners[corner];
            faces.push_back({mesh.positions[tet[face[0]]], mesh.positions[tet[face[1]]], mesh.positions[tet[face[2]]]});
        }
    }
    return faces;
}

double least_at(Vec3 node, const std::vector<OppositeFace>& faces) {
    double least = 1;
    for (const OppositeFace& f : faces) least = std::min(least, shape_of(node, f[0], f[1], f[2]));
    return least;
}

TEST(ShortestInHull, OfNothingIsZeroAndOfOneItself) {
    EXPECT_EQ(shortest_in_hull({}), Vec3{});
    const Vec3 one[] = {{1, 2, 3}};
    EXPECT_EQ(shortest_in_hull(one), (Vec3{1, 2, 3}));
}

TEST(ShortestInHull, LooksAtThePlaneOfThreeAndVanishesWhereTheyPullApart) {
    const Vec3 plane[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Vec3 third{1.0 / 3, 1.0 / 3, 1.0 / 3};
    EXPECT_LT(length(shortest_in_hull(plane) - third), 0.1);
    const Vec3 apart[] = {{1, 0, 0}, {-2, 0, 0}, {0, 3, 0}};
    EXPECT_LT(length(shortest_in_hull(apart)), 1e-12);
}

TEST(Smoothing, AFlatStarIsNoPlaceToStart) {
    const TetMesh mesh = small::box_around({0.5, 0.5, 0.5});
    std::vector<OppositeFace> faces = faces_around(mesh, 8);
    EXPECT_FALSE(find_better_place({0.5, 0.5, 0}, faces, 0));
    EXPECT_FALSE(find_better_place({3, 3, 3}, faces, 0));
}

TEST(Smoothing, ANodeInACornerOfABoxGoesToTheMiddle) {
    const TetMesh mesh = small::box_around({0.5, 0.5, 0.5});
    std::vector<OppositeFace> faces = faces_around(mesh, 8);
    const double wanted = least_at({0.5, 0.5, 0.5}, faces);
    Rng rng(3);
    for (int round = 0; round < 50; ++round) {
        const Vec3 start =
            round_to_float({0.1 + 0.8 * rng.next_unit(), 0.1 + 0.8 * rng.next_unit(), 0.1 + 0.8 * rng.next_unit()});
        Vec3 place = start;
        for (int step = 0; step < 10; ++step) {
            const auto better = find_better_place(place, faces, 0);
            if (!better) break;
            EXPECT_GT(better->least, least_at(place, faces));
            EXPECT_NEAR(better->least, least_at(better->place, faces), 1e-15);
            EXPECT_EQ(better->place, round_to_float(better->place));
            place = better->place;
        }
        EXPECT_GT(least_at(place, faces), 0.97 * wanted);
    }
}

TEST(Smoothing, WhatDoesNotBeatTheFloorIsNoPlace) {
    const TetMesh mesh = small::box_around({0.5, 0.5, 0.5});
    std::vector<OppositeFace> faces = faces_around(mesh, 8);
    EXPECT_FALSE(find_better_place({0.3, 0.4, 0.5}, faces, 0.99));
    EXPECT_TRUE(find_better_place({0.3, 0.4, 0.5}, faces, 0));
}

}
}
