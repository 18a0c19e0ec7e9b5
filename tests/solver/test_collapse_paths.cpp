// SPDX-License-Identifier: MIT
// S2: thousands of tets whose corner swings through its opposite face and back, half of the steps inside out, each at
// its own place of the swing. Their rotations follow without a jump.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/body.h"
#include "solver/effort.h"

namespace crumple::solver::test {
namespace {

constexpr int steps_of_swing = 200;
constexpr float dt = 0.01f;

// Tets with three corners on z = 0 and one above the first, at distance 1; one beside the other, none touches.
Bundle apart(int count) {
    std::vector<Vec3f> rest;
    std::vector<Tet> tets;
    for (int i = 0; i < count; ++i) {
        const Vec3f at{static_cast<float>(2 * (i % 64)), static_cast<float>(2 * (i / 64)), 0};
        const auto first = static_cast<Index>(rest.size());
        for (const Vec3f corner : {Vec3f{}, Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}})
            rest.push_back(at + corner);
        tets.push_back({first, first + 1, first + 2, first + 3});
    }
    return bundle_of(rest, tets, elastic_material(1e4), [](Vec3f p) { return p.z == 0; });
}

// Of the swinging corner, from the first one.
Vec3f place_at(double swing) {
    const double angle = 2 * 3.14159265358979 * swing;
    return {static_cast<float>(0.25 + 0.2 * std::sin(angle)), static_cast<float>(0.25 + 0.1 * std::cos(3 * angle)),
            static_cast<float>(std::cos(angle))};
}

// The largest change of a rotation in a step, of 2 |v| dt / h.
double largest_jump(Body& body, std::span<const double> phases, int steps) {
    std::vector<Constraint> pulls(phases.size());
    std::vector<Mat3> before(phases.size());
    double largest = 0;
    for (int s = 0; s < steps; ++s) {
        for (std::size_t t = 0; t < phases.size(); ++t) {
            const Index corner = body.bundle.tets[t][3];
            const Vec3f to = body.rest(body.bundle.tets[t][0]) + place_at(phases[t] + 1.0 * (s + 1) / steps_of_swing);
            pulls[t] = {corner, ConstraintKind::fixed, (to - body.x(corner)) / dt, {}, {}};
            before[t] = rotation(body.state, t);
        }
        StepInput input;
        input.dt = dt;
        input.constraints = pulls;
        body.step(input);
        // The first steps find the rotations there are.
        for (std::size_t t = 0; t < phases.size() && s > 2; ++t) {
            const double allowed = 2 * static_cast<double>(length(pulls[t].velocity) * dt);
            largest = std::max(largest, static_cast<double>(norm(rotation(body.state, t) - before[t])) / allowed);
        }
    }
    return largest;
}

}

TEST(S2HalfInverted, RotationsFollowWithoutAJump) {
    const int count = test::effort(1024, 8192, 64);
    const Bundle bundle = apart(count);
    Rng rng(2);
    std::vector<double> phases;
    // Whole when it begins.
    for (int i = 0; i < count; ++i) phases.push_back(0.2 * rng.next_unit());
    for (const Treatment treatment : {Treatment::reflect, Treatment::project, Treatment::smooth}) {
        Settings settings;
        settings.treatment = treatment;
        settings.max_iterations = 1;
        Body body(bundle, settings);
        EXPECT_LE(largest_jump(body, phases, test::effort(250, 1000, 100)), 1) << name_of(treatment);
    }
}

}
