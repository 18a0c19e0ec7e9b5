// SPDX-License-Identifier: MIT
// Frames of a game with a bad number in them: said, without load, the state as it was.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "solver/body.h"
#include "solver/check_input.h"
#include "solver/check_state.h"

namespace crumple::solver::test {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double endless = std::numeric_limits<double>::infinity();
constexpr float none_f = std::numeric_limits<float>::quiet_NaN();

// A bar with a locked end, a floor in its free one and one of everything a step can be given.
struct Crash {
    Crash() : body(grid_body({4, 2, 2}, {0.3f, 0.3f, 0.3f}, elastic_material(), [](Vec3f p) { return p.x > 1; })) {
        room.resize(2 * body.node_count());
        forces.resize(body.node_count());
        floor.position = {0, 0.01, 0};
        box.shape = ObstacleShape::box;
        box.axis = {1, 1, 1};
        box.position = {0, -5, 0};
        constraint.node = 40;
        input.carrier.velocity = {0, -5, 0};
    }
    InstanceReport step() {
        const Obstacle obstacles[] = {floor, box};
        input.obstacles = obstacles;
        input.hits = {&hit, has_hit ? 1u : 0u};
        input.wind = has_wind ? &wind : nullptr;
        input.forces = forces;
        input.room = room;
        return step_instance(body.model, body.state, body.workspace, input, body.settings);
    }
    std::vector<std::byte> bytes() { return {body.bytes().begin(), body.bytes().end()}; }

    Body body;
    InstanceInput input;
    Obstacle floor, box;
    Hit hit{{0, 0.3, 0.3}, {1, 0, 0}};
    Wind wind;
    Constraint constraint;
    std::vector<Vec3f> forces;
    std::vector<Constraint> room;
    bool has_hit = false;
    bool has_wind = false;
};

struct Bad {
    const char* what;
    std::function<void(Crash&)> spoil;
};

// What a body looks at even while it sleeps.
const std::vector<Bad>& bad_worlds() {
    static const std::vector<Bad> all = {
        {"carrier nowhere", [](Crash& c) { c.input.carrier.position.x = none; }},
        {"carrier infinitely far", [](Crash& c) { c.input.carrier.position.z = endless; }},
        {"carrier too far for floats", [](Crash& c) { c.input.carrier.position.z = 1e30; }},
        {"carrier's velocity", [](Crash& c) { c.input.carrier.velocity.y = none; }},
        {"carrier's turning", [](Crash& c) { c.input.carrier.angular_velocity.y = none; }},
        {"no orientation",
         [](Crash& c) {
             c.input.carrier.orientation = {0, 0, 0, 0};
         }},
        {"orientation not a number", [](Crash& c) { c.input.carrier.orientation.w = none_f; }},
        {"acceleration that counts",
         [](Crash& c) {
             c.input.has_inertia = true;
             c.input.carrier.acceleration.x = none;
         }},
        {"gravity", [](Crash& c) { c.input.gravity.y = none; }},
        {"gravity beyond floats", [](Crash& c) { c.input.gravity.y = 1e30; }},
        {"hit", [](Crash& c) { c.has_hit = true, c.hit.momentum.x = none; }},
        {"hit nowhere", [](Crash& c) { c.has_hit = true, c.hit.position.x = endless; }},
        {"hit beyond floats", [](Crash& c) { c.has_hit = true, c.hit.momentum.x = 1e30; }},
        {"sleep speed", [](Crash& c) { c.input.sleep.speed = none_f; }},
        {"plane without axis", [](Crash& c) { c.floor.axis = {}; }},
        {"plane's axis",
         [](Crash& c) {
             c.floor.axis = {0, none, 0};
         }},
        {"plane's axis infinite",
         [](Crash& c) {
             c.floor.axis = {0, endless, 0};
         }},
        {"obstacle nowhere", [](Crash& c) { c.floor.position.y = none; }},
        {"obstacle's velocity", [](Crash& c) { c.floor.velocity.y = none; }},
        {"obstacle's turning", [](Crash& c) { c.floor.angular_velocity.y = endless; }},
        {"restitution", [](Crash& c) { c.floor.restitution = none_f; }},
        {"restitution above 1", [](Crash& c) { c.floor.restitution = 2; }},
        {"radius", [](Crash& c) { c.floor.radius = none; }},
        {"capsule's radius", [](Crash& c) { c.floor.shape = ObstacleShape::capsule, c.floor.radius = -1; }},
        {"capsule's axis", [](Crash& c) { c.floor.shape = ObstacleShape::capsule, c.floor.axis.x = none; }},
        {"box's edge", [](Crash& c) { c.box.axis.z = -1; }},
        {"box's orientation",
         [](Crash& c) {
             c.box.orientation = {0, 0, 0, 0};
         }},
        {"no shape", [](Crash& c) { c.floor.shape = static_cast<ObstacleShape>(9); }},
    };
    return all;
}

const std::vector<Bad>& bad_steps() {
    static const std::vector<Bad> all = {
        {"no time", [](Crash& c) { c.input.dt = 0; }},
        {"time backwards", [](Crash& c) { c.input.dt = -1; }},
        {"time not a number", [](Crash& c) { c.input.dt = none_f; }},
        {"endless time", [](Crash& c) { c.input.dt = std::numeric_limits<float>::infinity(); }},
        {"mass", [](Crash& c) { c.input.carrier_mass = none; }},
        {"mass below 0", [](Crash& c) { c.input.carrier_mass = -1; }},
        {"force", [](Crash& c) { c.forces[5].x = none_f; }},
        {"one force too few", [](Crash& c) { c.forces.pop_back(); }},
        {"wind", [](Crash& c) { c.has_wind = true, c.wind.velocity.x = none_f; }},
        {"air", [](Crash& c) { c.has_wind = true, c.wind.density_kg_m3 = -1; }},
        {"plasticity of another state", [](Crash& c) { c.body.settings.plasticity = Plasticity::multiplicative; }},
    };
    return all;
}

void expect_refused(const Bad& bad, bool is_asleep) {
    Crash crash;
    EXPECT_GT(crash.step().contacts, 0u);
    crash.body.state.header->is_asleep = is_asleep ? 1 : 0;
    const std::vector<std::byte> before = crash.bytes();
    bad.spoil(crash);
    const InstanceReport report = crash.step();
    EXPECT_EQ(report.step.warnings, std::uint32_t{step_bad_input}) << bad.what;
    EXPECT_EQ(report.load.force, Vec3{}) << bad.what;
    EXPECT_EQ(report.load.torque, Vec3{}) << bad.what;
    EXPECT_EQ(report.contacts, 0u) << bad.what;
    EXPECT_FALSE(report.is_asleep) << bad.what;
    EXPECT_EQ(crash.bytes(), before) << bad.what;
}

void expect_same_as_without(const std::function<void(Crash&)>& change) {
    Crash plain, changed;
    change(changed);
    plain.step();
    EXPECT_EQ(changed.step().step.warnings & step_bad_input, 0u);
    EXPECT_EQ(changed.bytes(), plain.bytes());
}

}

TEST(CheckInput, ABadNumberDoesNothingAndPushesNobody) {
    for (const Bad& bad : bad_worlds()) expect_refused(bad, false);
    for (const Bad& bad : bad_steps()) expect_refused(bad, false);
}

TEST(CheckInput, ASleeperIsToldOfABadWorldToo) {
    for (const Bad& bad : bad_worlds()) expect_refused(bad, true);
}

TEST(CheckInput, WhatIsNotUsedIsNotLookedAt) {
    expect_same_as_without([](Crash& c) { c.input.carrier.acceleration = {none, none, none}; });
    expect_same_as_without([](Crash& c) { c.floor.orientation = {0, 0, 0, 0}; });
    expect_same_as_without([](Crash& c) { c.input.sleep.wake_speed = std::numeric_limits<float>::infinity(); });
}

TEST(CheckInput, APlanesAxisMayHaveAnyLength) {
    for (const double length : {5e-324, 1e-200, 3.0, 1e200, 1.7e308}) {
        expect_same_as_without([&](Crash& c) { c.floor.axis = {0, length, 0}; });
    }
}

TEST(CheckInput, ABadConstraintIsLeftOutAlone) {
    Crash crash;
    crash.constraint.velocity.x = none_f;
    crash.input.constraints = {&crash.constraint, 1};
    const InstanceReport report = crash.step();
    EXPECT_NE(report.step.warnings & step_bad_constraint, 0u);
    EXPECT_EQ(report.step.warnings & step_bad_input, 0u);
    EXPECT_TRUE(crash.body.is_finite());
}

// Numbers that are allowed may still lead out of float: the load stays finite, and what is left can be saved.
TEST(CheckInput, WhatOverflowsEndsInFiniteStatesAndLoads) {
    const std::vector<Bad> wild = {
        {"hit",
         [](Crash& c) {
             c.has_hit = true, c.hit.momentum = {1e18, -1e17, 1e16};
         }},
        {"force",
         [](Crash& c) {
             c.forces[5] = {1e18f, 1e18f, -1e18f};
         }},
        {"gravity",
         [](Crash& c) {
             c.input.gravity = {0, -1e18, 0};
         }},
        {"time", [](Crash& c) { c.input.dt = 1e18f; }},
        {"little time", [](Crash& c) { c.input.dt = 1e-38f; }},
        {"carrier",
         [](Crash& c) {
             c.input.carrier.velocity = {1e18, -1e18, 1e18};
         }},
        {"turning",
         [](Crash& c) {
             c.input.has_inertia = true, c.input.carrier.angular_velocity = {1e18, 1e17, 1e18};
         }},
        {"obstacle",
         [](Crash& c) {
             c.floor.velocity = {0, 1e18, 0}, c.floor.angular_velocity = {1e18, 0, 0};
         }},
        {"node",
         [](Crash& c) {
             set_velocity(c.body.state, 3, {none_f, 0, 0});
         }},
    };
    for (const Bad& what : wild) {
        Crash crash;
        crash.step();
        for (int i = 0; i < 6; ++i) {
            if (i < 3) what.spoil(crash);
            if (i == 3) crash.input = Crash().input;
            const InstanceReport report = crash.step();
            EXPECT_TRUE(std::isfinite(length(report.load.force))) << what.what << i;
            EXPECT_TRUE(std::isfinite(length(report.load.torque))) << what.what << i;
            EXPECT_EQ(first_problem(crash.body.model, crash.body.state), nullptr) << what.what << i;
        }
    }
}

}
