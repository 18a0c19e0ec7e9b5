// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/give_way.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/random.h"
#include "mesh/validate.h"
#include "small_meshes.h"

namespace crumple::finish {
namespace {

bool is_manifold_at(const TetSelection& tets, const std::vector<Index>& nodes) {
    return std::all_of(nodes.begin(), nodes.end(), [&](Index v) { return tets.is_manifold(v); });
}

// What must hold of a mesh that gave way: nodes as they were come first, each still in a tet, and the change says what
// it cost.
void expect_gave_way(const TetMesh& before, const SurfaceChange& change, TetMesh after) {
    EXPECT_TRUE(small::is_all_positive(after));
    EXPECT_TRUE(validate(after, 8).empty());
    EXPECT_TRUE(std::equal(before.positions.begin(), before.positions.end(), after.positions.begin()));
    EXPECT_EQ(after.positions.size(), before.positions.size() + change.places.size());
    EXPECT_NEAR(small::volume_of(before) - small::volume_of(after), change.cost, 1e-12);
    EXPECT_GT(change.cost, 0);
    std::vector<std::uint8_t> is_used(after.positions.size(), 0);
    for (const Tet& tet : after.tets) {
        for (const Index v : tet) is_used[v] = 1;
    }
    for (const Tet& tet : before.tets) {
        for (const Index v : tet) EXPECT_TRUE(is_used[v]) << v;
    }
}

TEST(GiveWay, TwoBlocksThatShareAnEdgeAreBentApartAlongIt) {
    const TetMesh mesh = small::cells(2, [](int x, int y, int z) { return x == y && z == 0; });
    TetSelection tets(mesh);
    const Index low = small::node_at(mesh, {1, 1, 0});
    const Index high = small::node_at(mesh, {1, 1, 1});
    ASSERT_EQ(tets.bad_ends_at(low), std::vector<Index>{high});
    const SurfaceChange change = bend_off_edge(tets, low, high);
    ASSERT_EQ(change.places.size(), 1u) << "the larger part, or the first, keeps the edge";
    tets.put(change);
    EXPECT_TRUE(tets.bad_ends_at(low).empty());
    EXPECT_TRUE(tets.bad_ends_at(high).empty());
    EXPECT_FALSE(tets.is_manifold(low)) << "they still touch at its ends";
    expect_gave_way(mesh, change, std::move(tets).take());
}

// A part that goes nearly all the way around an edge, its tets at 0, 160 and 320 degrees, and a long wedge in the gap:
// the middle of its corners lies in the wedge.
TetMesh fan_and_wedge() {
    const auto around = [](double degrees, double radius) {
        const double angle = degrees * std::numbers::pi / 180;
        return Vec3{radius * std::cos(angle), radius * std::sin(angle), 0};
    };
    return small::mesh_of(
        {{0, 0, -1}, {0, 0, 1}, around(0, 1), around(160, 0.3), around(320, 1), around(325, 8), around(355, 8)},
        {{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 5, 6}}, 7);
}

// In how many tets a place lies.
int tets_around(const TetMesh& mesh, Vec3 place) {
    return static_cast<int>(std::count_if(mesh.tets.begin(), mesh.tets.end(), [&](const Tet& tet) {
        return std::all_of(std::begin(tet_face_corners), std::end(tet_face_corners), [&](const auto& face) {
            return orient3d(mesh.positions[tet[face[0]]], mesh.positions[tet[face[1]]], mesh.positions[tet[face[2]]],
                            place) < 0;
        });
    }));
}

TEST(GiveWay, APartThatGoesNearlyAroundAnEdgeStaysOutOfTheGap) {
    const TetMesh mesh = fan_and_wedge();
    ASSERT_TRUE(small::is_all_positive(mesh));
    TetSelection tets(mesh);
    const SurfaceChange change = bend_off_edge(tets, 0, 1);
    ASSERT_FALSE(change.is_empty());
    tets.put(change);
    const TetMesh after = std::move(tets).take();
    expect_gave_way(mesh, change, after);
    Rng random(1, 0);
    for (int i = 0; i < 20000; ++i) {
        const double x = 8 * random.next_unit();
        const double y = -5 * random.next_unit();
        const Vec3 place{0.2 * (x - 1), 0.2 * (y + 2), random.next_unit() - 0.5};
        EXPECT_LE(tets_around(after, place), tets_around(mesh, place));
    }
}

TEST(GiveWay, AnEdgeOfOnePartIsLeftAlone) {
    const TetMesh mesh = small::ring(5, 1);
    const TetSelection tets(mesh);
    EXPECT_TRUE(bend_off_edge(tets, 0, 1).is_empty());
    EXPECT_TRUE(bend_off_edge(tets, 0, 2).is_empty());
    EXPECT_TRUE(bend_off_edge(tets, 2, 5).is_empty()) << "no edge at all";
}

TEST(GiveWay, TwoCavitiesThatTouchAtANodeBecomeOne) {
    TetMesh mesh = small::cells(4, [](int x, int y, int z) { return x != y || y != z || x == 0 || x == 3; });
    for (Index t = 0; t < mesh.tets.size(); ++t) mesh.region[t] = t % 8;
    TetSelection tets(mesh);
    const Index node = small::node_at(mesh, {2, 2, 2});
    ASSERT_FALSE(tets.is_manifold(node));
    const SurfaceChange change = cut_tips(tets, node);
    tets.put(change);
    EXPECT_EQ(tets.tets_at(node).size(), 1u);
    EXPECT_TRUE(is_manifold_at(tets, tets.nodes_of(change)));
    for (std::size_t i = 0; i < change.added.size(); ++i) {
        EXPECT_EQ(tets.mesh().region[mesh.tets.size() + i], mesh.region[change.like[i]]);
    }
    const TetMesh after = std::move(tets).take();
    EXPECT_TRUE(non_manifold(boundary_of(after).faces).vertices.empty());
    expect_gave_way(mesh, change, after);
}

TEST(GiveWay, WhatIsPutCanBeTakenBack) {
    const TetMesh mesh = small::cells(2, [](int x, int y, int z) { return x == y && z == 0; });
    TetSelection tets(mesh);
    const Index node = small::node_at(mesh, {1, 1, 0});
    for (const SurfaceChange& change :
         {cut_tips(tets, node), bend_off_edge(tets, node, small::node_at(mesh, {1, 1, 1}))}) {
        ASSERT_FALSE(change.is_empty());
        tets.put(change);
        tets.take_back(change);
    }
    const TetMesh after = std::move(tets).take();
    EXPECT_EQ(after.positions, mesh.positions);
    EXPECT_EQ(after.tets, mesh.tets);
    EXPECT_EQ(after.neighbours, mesh.neighbours);
    EXPECT_EQ(after.region, mesh.region);
}

TEST(GiveWay, ANodeOfNoTetHasNothingToCut) {
    TetMesh mesh = small::ring(3, 1);
    mesh.positions.push_back({5, 5, 5});
    EXPECT_TRUE(cut_tips(TetSelection(mesh), static_cast<Index>(mesh.positions.size() - 1)).is_empty());
}

}
}
