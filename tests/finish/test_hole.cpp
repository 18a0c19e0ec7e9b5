// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/hole.h"

#include <gtest/gtest.h>

#include <numeric>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

constexpr std::size_t enough = 100;

TEST(Hole, BadnessFallsFromOneToAHalfAndThenIsNone) {
    EXPECT_EQ(badness_of(0, 0.2), 1);
    EXPECT_NEAR(badness_of(0.1, 0.2), 0.75, 1e-15);
    EXPECT_NEAR(badness_of(0.1999999, 0.2), 0.5, 1e-6);
    EXPECT_EQ(badness_of(0.2, 0.2), 0);
    EXPECT_EQ(badness_of(0.1, 0), 0);
}

TEST(Hole, OpensUntilItsPlaceSeesAllOfIt) {
    // A place in the second tet of a box around its middle, the hole begun at the first.
    const TetMesh mesh = small::box_around({0.5, 0.5, 0.5});
    const WorkMesh work(mesh);
    const Index first = 0;
    const Tet& other = mesh.tets[1];
    Vec3 place{};
    for (const Index v : other) place += mesh.positions[v] * 0.25;
    Hole hole(work, place, std::span(&first, 1));
    ASSERT_TRUE(hole.open(0, enough));
    EXPECT_GT(hole.tets().size(), 1u);
    EXPECT_GT(hole.least(), 0);
    EXPECT_TRUE(hole.is_sound(false) || hole.is_sound(true));
}

TEST(Hole, DoesNotOpenThroughTheSurface) {
    const TetMesh mesh = small::box_around({0.5, 0.5, 0.5});
    const WorkMesh work(mesh);
    const Index first = 0;
    Hole outside(work, {3, 3, 3}, std::span(&first, 1));
    EXPECT_FALSE(outside.open(0, enough));
    Hole limited(work, {0.9, 0.9, 0.9}, std::span(&first, 1));
    EXPECT_FALSE(limited.open(0, 1));
}

TEST(Hole, DoesNotGrowWhereNothingIsBad) {
    const TetMesh mesh = small::box_around({0.5, 0.5, 0.5});
    const WorkMesh work(mesh);
    const Index first = 0;
    Vec3 middle{};
    for (const Index v : mesh.tets[0]) middle += mesh.positions[v] * 0.25;
    Hole hole(work, middle, std::span(&first, 1));
    hole.grow(1e-3, enough);
    EXPECT_EQ(hole.tets().size(), 1u);
}

TEST(Hole, SettlesWhereTheWorstTetIsBetterAndFewerAreBad) {
    const TetMesh mesh = small::box_around({0.5, 0.5, 0.5});
    const WorkMesh work(mesh);
    std::vector<Index> all(mesh.tets.size());
    std::iota(all.begin(), all.end(), Index{0});
    Hole hole(work, {0.9, 0.9, 0.9}, all);
    const double least = hole.least();
    hole.settle();
    EXPECT_GT(hole.least(), least);
    Hole other(work, {0.9, 0.9, 0.9}, all);
    const double before = other.new_badness(0.4);
    ASSERT_GT(before, 0);
    other.settle_badness(0.4);
    EXPECT_LT(other.new_badness(0.4), before);
    EXPECT_EQ(other.place(), round_to_float(other.place()));
    EXPECT_FALSE(other.is_sound(false)) << "it loses the node in the middle";
    EXPECT_TRUE(other.is_sound(true));
}

}
}
