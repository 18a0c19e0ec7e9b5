// SPDX-License-Identifier: MIT
#include "solver/constraints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/body.h"

namespace crumple::solver::test {
namespace {

const auto bottom = [](Vec3f p) { return p.y == 0; };

Settings exact() {
    Settings settings;
    settings.max_iterations = 1000;
    settings.tolerance = 1e-6;
    return settings;
}

Material damped(double young_pa = 1e5) {
    Material m = elastic_material(young_pa);
    m.alpha_per_s = 5;
    return m;
}

Constraint constraint(Index node, ConstraintKind kind, Vec3f velocity = {}, Vec3f normal = {}, Vec3f second = {}) {
    return {node, kind, velocity, normal, second};
}

}

TEST(Constraints, ThoseThatMakeNoSenseAreIgnoredAndReported) {
    Body body(grid_body({2, 2, 2}, {0.5f, 0.5f, 0.5f}, damped(), bottom), exact());
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Constraint bad[] = {constraint(1000, ConstraintKind::fixed),
                              constraint(3, ConstraintKind::fixed, {nan, 0, 0}), constraint(3, ConstraintKind::plane),
                              constraint(3, ConstraintKind::plane, {}, {nan, 0, 0}),
                              constraint(3, ConstraintKind::rail, {}, {1, 0, 0}, {2, 0, 0})};
    for (const Constraint& c : bad) {
        StepInput input;
        input.constraints = {&c, 1};
        EXPECT_EQ(body.step(input).warnings, static_cast<std::uint32_t>(step_bad_constraint));
        EXPECT_TRUE(body.is_finite());
    }
}

TEST(Constraints, ABodyWithoutAnyFreeNodeStandsStill) {
    Body body(grid_body({1, 1, 1}, {1, 1, 1}, damped()), exact());
    std::vector<Constraint> all;
    for (Index i = 0; i < 8; ++i) all.push_back(constraint(i, ConstraintKind::fixed));
    StepInput input;
    input.gravity = {0, -10, 0};
    input.constraints = all;
    EXPECT_EQ(body.step(input).iterations, 0u);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(body.x(i), body.rest(i));
}

TEST(Constraints, LockedNodesDoNotMoveABit) {
    Body body(grid_body({2, 3, 2}, {0.5f, 0.5f, 0.5f}, damped(), bottom), exact());
    body.set_velocities([](Vec3f) { return Vec3f{30, -20, 10}; });
    for (int i = 0; i < 60; ++i) body.step(1.0f / 60);
    for (std::size_t i = 0; i < body.node_count(); ++i) {
        if (bottom(body.rest(i))) {
            EXPECT_EQ(body.x(i), body.rest(i));
        }
    }
}

TEST(Constraints, APrescribedVelocityIsKeptAndTheLastOneCounts) {
    Body body(grid_body({2, 2, 2}, {0.5f, 0.5f, 0.5f}, damped(), bottom), exact());
    const Constraint both[] = {constraint(26, ConstraintKind::fixed, {5, 5, 5}),
                               constraint(26, ConstraintKind::fixed, {0, 1, 0}),
                               constraint(0, ConstraintKind::fixed, {0.5f, 0, 0})};  // node 0 is locked
    StepInput input;
    input.dt = 0.01f;
    input.constraints = both;
    for (int i = 0; i < 10; ++i) body.step(input);
    EXPECT_NEAR(body.x(26).y, body.rest(26).y + 0.1f, 1e-6f);
    EXPECT_NEAR(body.x(0).x, body.rest(0).x + 0.05f, 1e-6f);
}

TEST(Constraints, ANodeOnAPlaneSlidesInItAndOneOnARailAlongIt) {
    Body body(grid_body({2, 2, 2}, {0.5f, 0.5f, 0.5f}, damped()), exact());
    const Vec3f n{1, 1, 0};
    const Constraint slides[] = {constraint(0, ConstraintKind::plane, {0, 0, 0}, n),
                                 constraint(26, ConstraintKind::rail, {0.3f, 0, 0}, {1, 0, 0}, {1, 1, 0})};
    StepInput input;
    input.gravity = {3, -10, 2};
    input.constraints = slides;
    for (int i = 0; i < 60; ++i) body.step(input);
    EXPECT_NEAR(dot(body.x(0) - body.rest(0), n), 0, 1e-5f);
    EXPECT_GT(length(body.x(0) - body.rest(0)), 0.1f);
    EXPECT_NEAR(body.x(26).x - body.rest(26).x, 0.3f, 1e-4f);
    EXPECT_NEAR(body.x(26).y - body.rest(26).y, 0, 1e-5f);
    EXPECT_GT(std::fabs(body.x(26).z - body.rest(26).z), 0.1f);
}

// Its body pulls it back as if there were no obstacle.
TEST(Constraints, AContactThatANodeIsLeavingDoesNotHoldIt) {
    Body with(grid_body({2, 2, 2}, {0.5f, 0.5f, 0.5f}, damped(), bottom), exact());
    Body without(grid_body({2, 2, 2}, {0.5f, 0.5f, 0.5f}, damped(), bottom), exact());
    const Index top = 8;
    const Constraint contact = constraint(top, ConstraintKind::contact, {0, -5, 0}, {0, 1, 0});
    StepInput input;
    for (Body* body : {&with, &without}) set_velocity(body->state, top, {0, 10, 0});
    input.constraints = {&contact, 1};
    const std::uint32_t iterations = with.step(input).iterations;
    EXPECT_EQ(iterations, without.step(input.dt).iterations);
    EXPECT_LT(velocity(without.state, top).y, 9);
    for (std::size_t i = 0; i < with.node_count(); ++i) {
        EXPECT_LT(length(velocity(with.state, i) - velocity(without.state, i)), 1e-3f) << i;
    }
}

// S8: what holds the body up pushes with its weight.
// One node on a rail, the rest blown away from it: a solve cut short ends in a translation that the rail allows.
TEST(Constraints, APushedBodyIsNotTornOffItsRailForWantOfIterations) {
    for (const std::uint32_t iterations : {1u, 2u, 5u, 40u}) {
        Settings settings;
        settings.max_iterations = iterations;
        Material stiff = elastic_material(7e8, 0.36);
        stiff.density_kg_m3 = 57;
        Body body(grid_body({2, 2, 2}, {0.3f, 0.3f, 0.3f}, stiff), settings);
        const Constraint rail = constraint(0, ConstraintKind::rail, {}, {0, 1, 0}, {0, 0, 1});
        Rng rng(3, iterations);
        std::vector<Vec3f> forces(body.node_count());
        StepInput input;
        input.dt = 1.0f / 30;
        input.constraints = {&rail, 1};
        input.forces = forces;
        double work = 0;
        for (int i = 0; i < 30; ++i) {
            for (Vec3f& f : forces) f = random_vector(rng) * 1e4f;
            const StepReport report = body.step(input);
            double push = 0;
            for (std::size_t n = 0; n < forces.size(); ++n)
                push += dot(widen(forces[n]), widen(velocity(body.state, n))) / 30;
            work += std::max(0.0, push);
            EXPECT_LE(report.energy, 2 * work + 1e-3) << iterations << " iterations, step " << i;
        }
    }
}

TEST(S8FixedNodes, ReactionsSumToTheLoad) {
    Body body(grid_body({2, 4, 2}, {0.5f, 0.5f, 0.5f}, damped(1e6), bottom), exact());
    std::vector<Vec3f> reactions(body.node_count());
    StepInput input;
    input.gravity = {0, -10, 0};
    input.reactions = reactions;
    for (int i = 0; i < 500; ++i) body.step(input);
    Vec3 push;
    double weight = 0;
    for (std::size_t i = 0; i < body.node_count(); ++i) {
        push += Vec3{reactions[i].x, reactions[i].y, reactions[i].z};
        weight += 10 * body.bundle.mass[i];
        if (!bottom(body.rest(i))) {
            EXPECT_EQ(reactions[i], Vec3f{});
        }
    }
    EXPECT_NEAR(push.y, weight, 1e-3 * weight);
    EXPECT_NEAR(push.x, 0, 1e-3 * weight);
}

// S8: with any set of fixed and sliding nodes the matrix stays positive definite on what is free.
TEST(S8FixedNodes, AnyRandomSetSolvesWithoutALossOfDefiniteness) {
    for (int share = 0; share <= 95; share += 19) {
        Body body(grid_body({3, 3, 3}, {0.3f, 0.3f, 0.3f}, elastic_material(1e6)), exact());
        Rng rng(static_cast<std::uint64_t>(share));
        std::vector<Constraint> some;
        for (Index i = 0; i < body.node_count(); ++i) {
            if (rng.next_unit() * 100 > share) continue;
            const auto kind = static_cast<ConstraintKind>(rng.next_below(3));
            const Vec3f velocity = random_vector(rng);
            const Vec3f normal = random_vector(rng);
            some.push_back(constraint(i, kind, velocity, normal, random_vector(rng)));
        }
        body.set_positions([&](Vec3f p) { return p + random_vector(rng) * 0.05f; });
        StepInput input;
        input.constraints = some;
        for (int i = 0; i < 10; ++i) {
            const StepReport report = body.step(input);
            EXPECT_EQ(report.warnings, 0u) << share;
            EXPECT_LE(report.residual, 1.01e-6f) << share;
        }
        for (const Constraint& c : some) {
            const Vec3f off = velocity(body.state, c.node) - c.velocity;
            const Vec3f n = c.normal / length(c.normal);
            EXPECT_NEAR(dot(off, n), 0, 2e-4f);
            if (c.kind == ConstraintKind::fixed) {
                EXPECT_EQ(off, Vec3f{});
            }
        }
    }
}

}
