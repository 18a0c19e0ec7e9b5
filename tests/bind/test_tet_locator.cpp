// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/tet_locator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bind/tet_side.h"
#include "core/random.h"
#include "mesh/neighbours.h"
#include "mesh/shapes.h"

namespace crumple::bind {
namespace {

TetMesh grid(int cells) {
    TetMesh mesh = shapes::tet_grid(cells);
    mesh.region.assign(mesh.tets.size(), 0);
    return mesh;
}

std::array<Vec3, 4> corners_of(const TetMesh& mesh, Index t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    return {mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]};
}

Vec3 place(const TetMesh& mesh, const Location& at) {
    Vec3 sum;
    for (int i = 0; i < 4; ++i) sum += mesh.positions[mesh.tets[at.tet][i]] * at.weights[i];
    return sum;
}

double distance_to(const TetMesh& mesh, Index t, Vec3 p) {
    const auto tet = corners_of(mesh, t);
    double least = 1e300;
    for (const auto& [a, b, c] : tet_face_corners) {
        least = std::min(least, length(closest_point_on_triangle(tet[a], tet[b], tet[c], p) - p));
    }
    return least;
}

Vec3 random_point(Rng& rng, double low, double high) {
    const double x = low + (high - low) * rng.next_unit();
    const double y = low + (high - low) * rng.next_unit();
    return {x, y, low + (high - low) * rng.next_unit()};
}

TEST(TetLocator, ContainedPointsAreInATetThatContainsThem) {
    const TetMesh mesh = grid(5);
    const TetLocator locator(mesh, none, {});
    Rng rng(1);
    Guess guess;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p = i < 200 ? mesh.positions[i] : random_point(rng, 0, 1);
        const Location at = locator.locate(p, guess);
        EXPECT_TRUE(at.inside);
        EXPECT_EQ(at.distance, 0);
        EXPECT_NE(side_of_tet(corners_of(mesh, at.tet), p).side, Side::outside);
        EXPECT_LT(length(place(mesh, at) - p), 1e-12);
    }
}

TEST(TetLocator, OutsidePointsHangOnTheNearestTetUnclamped) {
    const TetMesh mesh = grid(3);
    const TetLocator locator(mesh, none, {});
    Rng rng(2);
    Guess guess;
    int outside = 0;
    for (int i = 0; i < 500; ++i) {
        const Vec3 p = random_point(rng, -1, 2);
        const Location at = locator.locate(p, guess);
        EXPECT_LT(length(place(mesh, at) - p), 1e-12);
        if (at.inside) continue;
        ++outside;
        double least = 1e300;
        for (Index t = 0; t < mesh.tets.size(); ++t) least = std::min(least, distance_to(mesh, t, p));
        EXPECT_NEAR(at.distance, least, 1e-12);
        EXPECT_NEAR(distance_to(mesh, at.tet, p), least, 1e-12);
        EXPECT_LT(*std::min_element(at.weights.begin(), at.weights.end()), 0);
    }
    EXPECT_GT(outside, 300);
}

TEST(TetLocator, OfEquallyNearTetsTheLeastExtrapolatingWins) {
    const TetMesh mesh = grid(2);
    const TetLocator locator(mesh, none, {});
    for (const Vec3 p :
         {Vec3{-0.5, -0.5, -0.5}, Vec3{1.5, 1.25, 0.5}, Vec3{0.5, -0.25, -0.25}, Vec3{1.25, 1.5, -0.75}}) {
        Guess guess;
        const Location at = locator.locate(p, guess);
        double best = 1e300;
        for (Index t = 0; t < mesh.tets.size(); ++t) {
            if (distance_to(mesh, t, p) > at.distance + 1e-12) continue;
            const auto tet = corners_of(mesh, t);
            double largest = 0;
            for (const double w : barycentric(tet[0], tet[1], tet[2], tet[3], p))
                largest = std::max(largest, std::fabs(w));
            best = std::min(best, largest);
        }
        double largest = 0;
        for (const double w : at.weights) largest = std::max(largest, std::fabs(w));
        EXPECT_NEAR(largest, best, 1e-12);
    }
}

TEST(TetLocator, GuessesAndTheOrderOfTetsAndNodesDoNotMatter) {
    const TetMesh mesh = grid(3);
    // The same tets in another order, over nodes in another order, corners rotated evenly.
    TetMesh other;
    std::vector<Index> node(mesh.positions.size());
    std::iota(node.begin(), node.end(), Index{0});
    std::reverse(node.begin(), node.end());
    for (const Index v : node) other.positions.push_back(mesh.positions[v]);
    for (auto tet = mesh.tets.rbegin(); tet != mesh.tets.rend(); ++tet) {
        const auto& [a, b, c, d] = *tet;
        other.tets.push_back({node[b], node[c], node[a], node[d]});
    }
    other.neighbours = neighbours_of(other.tets);
    other.region.assign(other.tets.size(), 0);
    const TetLocator one(mesh, none, {});
    const TetLocator two(other, none, {});
    Rng rng(3);
    Guess guess;
    for (int i = 0; i < 1000; ++i) {
        // Multiples of 1/6: on faces, edges and nodes more often than not.
        const Vec3 p =
            i % 2 ? random_point(rng, -0.5, 1.5)
                  : Vec3{std::floor(12 * rng.next_unit()) / 6 - 0.5, std::floor(12 * rng.next_unit()) / 6 - 0.5, 0.5};
        Guess no_guess;
        const Location a = one.locate(p, guess);
        const Location b = one.locate(p, no_guess);
        Guess fresh;
        const Location c = two.locate(p, fresh);
        EXPECT_EQ(a.tet, b.tet);
        EXPECT_EQ(a.weights, b.weights);
        EXPECT_EQ(c.tet, mesh.tets.size() - 1 - a.tet) << i;
        EXPECT_EQ(a.distance, c.distance);
    }
}

TEST(TetLocator, ASliverOnTheSurfaceLosesToWhatLiesBehindIt) {
    // A tet of height 1e-6 on top of a good one.
    TetMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, -1}, {0.25, 0.25, 1e-6}};
    mesh.tets = {{0, 2, 1, 3}, {0, 1, 2, 4}};
    mesh.region = {0, 0};
    mesh.neighbours = neighbours_of(mesh.tets);
    Preferences patient;
    patient.slack = 1e-4;
    const Vec3 p{0.3, 0.3, 0.1};
    Guess guess;
    const Location hasty = TetLocator(mesh, none, {}).locate(p, guess);
    EXPECT_EQ(hasty.tet, 1u);
    EXPECT_GT(*std::max_element(hasty.weights.begin(), hasty.weights.end()), 1e4);
    guess = {};
    const Location sound = TetLocator(mesh, none, patient).locate(p, guess);
    EXPECT_EQ(sound.tet, 0u);
    EXPECT_NEAR(sound.distance, 0.1, 1e-9);
    EXPECT_LT(*std::max_element(sound.weights.begin(), sound.weights.end()), 1.5);
}

TEST(TetLocator, OnlyTheTetsOfItsRegionCount) {
    TetMesh mesh = grid(2);
    for (Index t = 0; t < mesh.tets.size(); ++t) mesh.region[t] = t < 24 ? 0 : 1;  // x below and above 0.5
    Guess guess;
    const Location at = TetLocator(mesh, 1, {}).locate({0.25, 0.3, 0.3}, guess);
    EXPECT_FALSE(at.inside);
    EXPECT_EQ(mesh.region[at.tet], 1u);
    EXPECT_NEAR(at.distance, 0.25, 1e-12);
    EXPECT_TRUE(TetLocator(mesh, 7, {}).empty());
}

}
}
