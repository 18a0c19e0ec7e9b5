// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numeric>

#include "core/random.h"
#include "delaunay/delaunay.h"
#include "relax/method.h"
#include "relax/stars.h"

using namespace crumple;
using namespace crumple::relax;

namespace {

// The corners of the unit cube and one node inside.
TetMesh cube_around(Vec3 node) {
    PointSet points;
    for (int i = 0; i < 8; ++i) points.positions.push_back({i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
    points.shell_vertex_count = 8;
    points.positions.push_back(node);
    return delaunay::tetrahedralize(points).mesh;
}

void expect_near(Vec3 a, Vec3 b, double tolerance) { EXPECT_NEAR(length(a - b), 0, tolerance); }

template <class Check>
void for_star_of_last_node(const TetMesh& mesh, const Check& check) {
    const Stars stars = find_stars(mesh, std::vector<std::uint8_t>(mesh.tets.size(), 1));
    check(Star{mesh, static_cast<Index>(mesh.positions.size() - 1), stars.of(stars.start.size() - 2), true});
}

TEST(Cpt, TheTargetIsTheCentreOfTheStarWhereverTheNodeIs) {
    for (const Vec3 node : {Vec3{0.5, 0.5, 0.5}, Vec3{0.25, 0.5, 0.625}, Vec3{0.125, 0.125, 0.25}}) {
        const TetMesh mesh = cube_around(node);
        for_star_of_last_node(mesh, [](const Star& star) { expect_near(target_cpt(star), {0.5, 0.5, 0.5}, 1e-15); });
    }
}

TEST(Odt, OnASphereTheTargetIsItsCentreWhereverTheNodeIs) {
    // Interpolating |x - c|^2 errs least where the node's value reaches down to the sphere's centre.
    for (const Vec3 node : {Vec3{0.5, 0.5, 0.5}, Vec3{0.25, 0.5, 0.625}, Vec3{0.125, 0.125, 0.25}}) {
        const TetMesh mesh = cube_around(node);
        for_star_of_last_node(mesh, [](const Star& star) { expect_near(target_odt(star), {0.5, 0.5, 0.5}, 1e-14); });
    }
}

// Error of interpolating |x|^2 over the star, up to a constant: the volume-weighted sum of its node values.
double interpolated_integral(const Star& star, Vec3 node) {
    double sum = 0;
    for (const Index t : star.tets) {
        std::array<Vec3, 4> p;
        double values = 0;
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const Index v = star.mesh.tets[t][corner];
            p[corner] = v == star.node ? node : star.mesh.positions[v];
            values += dot(p[corner], p[corner]);
        }
        sum += dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0])) / 6 * values / 4;
    }
    return sum;
}

TetMesh random_mesh(std::uint64_t seed) {
    Rng rng(seed);
    PointSet points;
    for (int i = 0; i < 60; ++i)
        points.positions.push_back(round_to_float({rng.next_unit(), rng.next_unit(), rng.next_unit()}));
    points.positions.push_back({0.5, 0.5, 0.5});
    points.shell_vertex_count = 60;
    return delaunay::tetrahedralize(points).mesh;
}

TEST(Odt, TheTargetMinimizesTheInterpolationErrorOverTheStar) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const TetMesh mesh = random_mesh(seed);
        for_star_of_last_node(mesh, [](const Star& star) {
            const Vec3 target = target_odt(star);
            const double least = interpolated_integral(star, target);
            for (const Vec3 step : {Vec3{1e-3, 0, 0}, Vec3{0, 1e-3, 0}, Vec3{0, 0, 1e-3}}) {
                EXPECT_GT(interpolated_integral(star, target + step), least);
                EXPECT_GT(interpolated_integral(star, target - step), least);
            }
        });
    }
}

Vec3 sampled_cell_centre(const TetMesh& mesh, Index node, Rng& rng, int samples) {
    Vec3 sum;
    int hits = 0;
    for (int i = 0; i < samples; ++i) {
        const Vec3 p{rng.next_unit(), rng.next_unit(), rng.next_unit()};
        const auto distance_2 = [&](Vec3 q) { return dot(q - p, q - p); };
        const double own = distance_2(mesh.positions[node]);
        bool is_nearest = true;
        for (const Vec3 q : mesh.positions) is_nearest = is_nearest && own <= distance_2(q);
        if (!is_nearest) continue;
        sum += p;
        ++hits;
    }
    return sum / hits;
}

TEST(Lloyd, TheTargetIsTheCentreOfTheVoronoiCell) {
    int bounded = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const TetMesh mesh = random_mesh(seed);
        for_star_of_last_node(mesh, [&](const Star& star) {
            Rng rng(seed, 1);
            const Vec3 expected = sampled_cell_centre(mesh, star.node, rng, 100'000);
            // About 1500 samples fall into the cell of radius 0.15: a standard error of 0.003 an axis.
            expect_near(target_lloyd(star), expected, 0.02);
            ++bounded;
        });
    }
    EXPECT_EQ(bounded, 6);
}

TEST(Lloyd, AStarWithTetsMissingFallsBackToItsCentre) {
    const TetMesh mesh = random_mesh(1);
    for_star_of_last_node(mesh, [](const Star& star) {
        const Star part{star.mesh, star.node, star.tets.subspan(1), false};
        EXPECT_EQ(target_lloyd(part), target_cpt(part));
    });
}

TEST(Methods, EachIsListedOnce) {
    for (const auto& name : method_names) {
        int listed = 0;
        for (const MethodEntry& entry : methods) listed += entry.method == name.value ? 1 : 0;
        EXPECT_EQ(listed, 1) << name.name;
    }
}

TEST(Methods, MovingTheStarMovesTheTarget) {
    // By a distance that floats hold exactly.
    const Vec3 shift{4, -8, 16};
    TetMesh mesh = random_mesh(3);
    TetMesh moved = mesh;
    for (Vec3& p : moved.positions) p += shift;
    for (const MethodEntry& entry : methods) {
        for_star_of_last_node(mesh, [&](const Star& star) {
            const Star elsewhere{moved, star.node, star.tets, true};
            expect_near(entry.target(elsewhere), entry.target(star) + shift, 1e-13);
        });
    }
}

}
