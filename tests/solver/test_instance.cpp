// SPDX-License-Identifier: MIT
// Wind, and bodies that sleep while nothing happens.
#include <gtest/gtest.h>

#include <cstring>

#include "solver/body.h"
#include "solver/instance.h"

namespace crumple::solver::test {
namespace {

Bundle cube(const Material& m) { return grid_body({2, 2, 2}, {0.5f, 0.5f, 0.5f}, m); }

StepReport blow(Body& body, Vec3f velocity, float dt = 1.0f / 60) {
    Wind wind;
    wind.velocity = velocity;
    StepInput input;
    input.dt = dt;
    input.wind = &wind;
    return body.step(input);
}

Material clay() {
    Material m = elastic_material(1e6);
    m.yield_pa = 2e4;
    m.creep_per_s = 60;
    m.alpha_per_s = 1;
    m.beta_s = 0.01;
    return m;
}

struct Sleeper {
    explicit Sleeper(const Material& material = clay())
        : body(grid_body({4, 2, 2}, {0.3f, 0.3f, 0.3f}, material, [](Vec3f p) { return p.x > 1; })) {
        room.resize(body.node_count());
        input.gravity = {0, -9.81, 0};
        input.room = room;
        input.has_inertia = true;
        input.is_carrier_free = false;
    }
    InstanceReport step() { return step_instance(body.model, body.state, body.workspace, input, body.settings); }
    // Until it sleeps; seconds, or 100 when it does not.
    double settle() {
        for (int i = 1; i < 6000; ++i) {
            if (step().is_asleep) return i / 60.0;
        }
        return 100;
    }
    Body body;
    std::vector<Constraint> room;
    InstanceInput input;
};

}

// rho/2 C A v^2 on the face of a unit cube that meets the wind, nothing on the others.
TEST(Wind, PushesAFlatFaceByItsArea) {
    Body body(cube(elastic_material()));
    const StepReport report = blow(body, {10, 0, 0});
    EXPECT_NEAR(report.impulse.x * 60, 0.5 * 1.2 * 100, 1e-3);
    EXPECT_NEAR(report.impulse.y, 0, 1e-7);
    EXPECT_NEAR(linear_momentum(body.model, body.state).x, report.impulse.x, 1e-5);
}

TEST(Wind, AirThatMovesAlongDoesNothing) {
    Body body(cube(elastic_material()));
    body.set_velocities([](Vec3f) { return Vec3f{10, 3, 1}; });
    const StepReport report = blow(body, {10, 3, 1});
    EXPECT_EQ(length(report.impulse), 0);
}

TEST(Wind, AStormOnAFeatherDoesNotBlowUp) {
    Material m = elastic_material(1e4);
    m.density_kg_m3 = 0.1;
    Body body(cube(m));
    for (int i = 0; i < 200; ++i) blow(body, {300, 0, 0}, 1.0f / 20);
    EXPECT_TRUE(body.is_finite());
    for (std::size_t i = 0; i < body.node_count(); ++i) EXPECT_LT(length(velocity(body.state, i)), 400.0f);
}

TEST(Sleep, ABentBodySettlesAndSleeps) {
    Sleeper sleeper;
    const Hit hit{{0, 0.3, 0.3}, {200, -300, 0}};
    sleeper.input.hits = {&hit, 1};
    EXPECT_FALSE(sleeper.step().is_asleep);
    sleeper.input.hits = {};
    EXPECT_LT(sleeper.settle(), 10);
    EXPECT_GT(length(sleeper.body.x(0) - sleeper.body.rest(0)), 0.02f);  // and stays bent
}

TEST(Sleep, ASleeperChangesNoBit) {
    Sleeper sleeper;
    sleeper.settle();
    const std::vector<std::byte> before(sleeper.body.bytes().begin(), sleeper.body.bytes().end());
    Obstacle standing;
    standing.position = {0, -0.01, 0};
    sleeper.input.obstacles = {&standing, 1};
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(sleeper.step().is_asleep);
    EXPECT_EQ(std::memcmp(before.data(), sleeper.body.bytes().data(), before.size()), 0);
}

TEST(Sleep, WakesForWhatHappens) {
    const auto wakes = [](const std::function<void(Sleeper&)>& what) {
        Sleeper sleeper;
        sleeper.settle();
        what(sleeper);
        return !sleeper.step().is_asleep;
    };
    EXPECT_FALSE(wakes([](Sleeper&) {}));
    const Hit hit{{0, 0.3, 0.3}, {0, 0, 1}};
    EXPECT_TRUE(wakes([&](Sleeper& s) { s.input.hits = {&hit, 1}; }));
    EXPECT_TRUE(wakes([](Sleeper& s) { wake(s.body.state); }));
    EXPECT_TRUE(wakes([](Sleeper& s) { s.input.carrier.acceleration = {20, 0, 0}; }));
    EXPECT_TRUE(wakes([](Sleeper& s) { s.input.may_sleep = false; }));
    Obstacle ball;
    ball.shape = ObstacleShape::capsule;
    ball.axis = {};
    ball.radius = 0.5;
    ball.velocity = {10, 0, 0};
    ball.position = {-3, 0.3, 0.3};
    EXPECT_FALSE(wakes([&](Sleeper& s) { s.input.obstacles = {&ball, 1}; }));
    ball.position = {-0.6, 0.3, 0.3};
    EXPECT_TRUE(wakes([&](Sleeper& s) { s.input.obstacles = {&ball, 1}; }));
}

// Within the ball around the body, over its flat top.
TEST(Sleep, SleepsOnWhileSomethingPassesBy) {
    Sleeper sleeper;
    sleeper.settle();
    Obstacle passing;
    passing.shape = ObstacleShape::capsule;
    passing.axis = {};
    passing.radius = 0.1;
    passing.velocity = {0, 0, 5};
    passing.position = {0.6, 0.9, 0.3};
    sleeper.input.obstacles = {&passing, 1};
    EXPECT_TRUE(sleeper.step().is_asleep);
    passing.velocity = {0, -30, 0};
    EXPECT_FALSE(sleeper.step().is_asleep);
}

TEST(Sleep, WhatIsTooStiffForFloatSleepsToo) {
    Material stiff = clay();
    stiff.young_pa = 1e12;
    Sleeper sleeper(stiff);
    EXPECT_TRUE(sleeper.step().step.warnings & step_too_stiff);
    EXPECT_LT(sleeper.settle(), 10);
}

TEST(Sleep, ASavedSleeperSleepsOn) {
    Sleeper sleeper;
    sleeper.settle();
    const std::vector<std::byte> saved(sleeper.body.bytes().begin(), sleeper.body.bytes().end());
    Sleeper other;
    std::memcpy(other.body.bytes().data(), saved.data(), saved.size());
    EXPECT_TRUE(other.step().is_asleep);
}

}
