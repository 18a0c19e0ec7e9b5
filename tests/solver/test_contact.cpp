// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "solver/body.h"
#include "solver/instance.h"

namespace crumple::solver::test {
namespace {

Obstacle floor_at(double height, float restitution = 0) {
    Obstacle o;
    o.position = {0, height, 0};
    o.restitution = restitution;
    return o;
}

struct Dropped {
    explicit Dropped(Bundle bundle) : body(std::move(bundle)), room(body.node_count()) {}
    InstanceReport step(std::span<const Obstacle> obstacles, Vec3 gravity = {0, -9.81, 0}) {
        InstanceInput input;
        input.gravity = gravity;
        input.obstacles = obstacles;
        input.room = room;
        input.may_sleep = false;
        return step_instance(body.model, body.state, body.workspace, input, body.settings);
    }
    Body body;
    std::vector<Constraint> room;
};

Bundle block(double young_pa = 1e6) {
    Material m = elastic_material(young_pa);
    m.beta_s = 0.004;
    return grid_body({3, 3, 3}, {0.2f, 0.2f, 0.2f}, m);
}

}

// v' = v_t - k_r v_n of the nodes that touch, in the step they touch.
TEST(Contact, NodesReboundByTheRestitutionAndKeepTheirSlide) {
    Dropped dropped(block(1));
    dropped.body.set_velocities([](Vec3f) { return Vec3f{3, -5, 1}; });
    const Obstacle floor = floor_at(-0.01, 0.4f);
    const InstanceReport report = dropped.step({&floor, 1}, {});
    EXPECT_EQ(report.contacts, 16u);
    for (std::size_t i = 0; i < dropped.body.node_count(); ++i) {
        if (dropped.body.rest(i).y > 0) continue;
        EXPECT_NEAR(velocity(dropped.body.state, i).y, 2, 1e-5);
        EXPECT_NEAR(velocity(dropped.body.state, i).x, 3, 1e-3);
    }
}

TEST(Contact, AMovingWallHandsOverItsSpeed) {
    Dropped dropped(block(1e3));
    Obstacle wall = floor_at(-0.01, 0.5f);
    wall.velocity = {0, 4, 0};
    dropped.step({&wall, 1}, {});
    EXPECT_NEAR(velocity(dropped.body.state, 0).y, 4 + 0.5 * 4, 1e-5);
}

TEST(Contact, WithoutRestitutionItArrivesAtTheSurface) {
    Dropped dropped(block());
    dropped.body.set_velocities([](Vec3f) { return Vec3f{0, -6, 0}; });
    const Obstacle floor = floor_at(-0.05);
    dropped.step({&floor, 1});
    EXPECT_NEAR(dropped.body.x(0).y, -0.05, 1e-6);
}

TEST(Contact, ABlockDroppedComesToRestOnTheFloor) {
    Dropped dropped(block());
    const Obstacle floor = floor_at(-0.5);
    for (int i = 0; i < 600; ++i) dropped.step({&floor, 1});
    for (std::size_t i = 0; i < dropped.body.node_count(); ++i) {
        EXPECT_GT(dropped.body.x(i).y, -0.5 - 1e-3);
        EXPECT_LT(length(velocity(dropped.body.state, i)), 1e-2f);
    }
    EXPECT_LT(dropped.body.x(0).y, -0.49);
}

// The push of the floor carries the weight.
TEST(Contact, TheFloorBearsTheWeight) {
    Dropped dropped(block());
    const Obstacle floor = floor_at(0);
    Vec3 impulse;
    for (int i = 0; i < 600; ++i) {
        const Vec3 push = dropped.step({&floor, 1}).step.impulse;
        if (i >= 300) impulse += push;
    }
    double mass = 0;
    for (const float m : dropped.body.bundle.mass) mass += m;
    EXPECT_NEAR(impulse.y / (300.0 / 60), mass * 9.81, 0.02 * mass * 9.81);
}

TEST(Contact, APoleStaysOutside) {
    Material m = elastic_material(1e6);
    m.yield_pa = 2e4;
    m.beta_s = 0.004;
    Dropped dropped(grid_body({10, 3, 10}, {0.1f, 0.1f, 0.1f}, m));
    dropped.body.set_velocities([](Vec3f) { return Vec3f{-15, 0, 0}; });
    Obstacle pole;
    pole.shape = ObstacleShape::capsule;
    pole.position = {-0.3, 0, 0.5};
    pole.axis = {0, 5, 0};
    pole.radius = 0.2;
    for (int i = 0; i < 120; ++i) dropped.step({&pole, 1}, {});
    double deepest = 0;
    for (std::size_t i = 0; i < dropped.body.node_count(); ++i) {
        const Vec3f x = dropped.body.x(i);
        deepest = std::max(deepest, -nearest_surface(pole, {x.x, x.y, x.z}).distance);
    }
    EXPECT_LT(deepest, 0.01);
    EXPECT_TRUE(dropped.body.is_finite());
}

// In one step it would go three times its size into two walls: what they ask of its nodes would tear it apart.
TEST(Contact, AStiffBodyThatHitsHardGainsNoEnergyAndReactionsSumToItsMomentum) {
    for (const double young_pa : {1e6, 1e8, 1e9}) {
        Body body(grid_body({2, 1, 1}, {0.3f, 0.3f, 0.3f}, elastic_material(young_pa)));
        body.set_velocities([](Vec3f) { return Vec3f{-36, -60, 0}; });
        Obstacle walls[2];
        walls[0].axis = {0.5, 1, 0.3};
        walls[1].axis = {1, -0.2, 0.1};
        for (Obstacle& wall : walls) wall.position = {-0.05, -0.05, 0};
        std::vector<Constraint> room(body.node_count());
        std::vector<Vec3f> reactions(body.node_count());
        InstanceInput input;
        input.dt = 1.0f / 40;
        input.gravity = {};
        input.obstacles = walls;
        input.room = room;
        input.reactions = reactions;
        const double energy = kinetic_energy(body.model, body.state);
        const Vec3 momentum = linear_momentum(body.model, body.state);
        const StepReport report = step_instance(body.model, body.state, body.workspace, input, body.settings).step;
        EXPECT_EQ((report.warnings & step_restrained) != 0, young_pa > 1e6);
        EXPECT_LT(report.energy, energy) << young_pa;
        Vec3 sum;
        for (const Vec3f& reaction : reactions) sum += widen(reaction) * static_cast<double>(input.dt);
        const Vec3 gained = linear_momentum(body.model, body.state) - momentum;
        EXPECT_LT(length(sum - gained), 1e-3 * length(gained)) << young_pa;
        EXPECT_LT(length(report.impulse - gained), 1e-3 * length(gained)) << young_pa;
    }
}

TEST(Contact, SurfacesAreWhereTheyShouldBe) {
    Obstacle box;
    box.shape = ObstacleShape::box;
    box.axis = {1, 2, 3};
    EXPECT_DOUBLE_EQ(nearest_surface(box, {2, 0, 0}).distance, 1);
    EXPECT_EQ(nearest_surface(box, {2, 0, 0}).normal, (Vec3{1, 0, 0}));
    EXPECT_DOUBLE_EQ(nearest_surface(box, {0, -1.5, 0}).distance, -0.5 + 0.0 * 1);
    EXPECT_EQ(nearest_surface(box, {0, -1.5, 0}).normal, (Vec3{0, -1, 0}));
    EXPECT_NEAR(nearest_surface(box, {4, 6, 3}).distance, 5, 1e-6);
    Obstacle ball;
    ball.shape = ObstacleShape::capsule;
    ball.axis = {};
    ball.radius = 2;
    EXPECT_DOUBLE_EQ(nearest_surface(ball, {0, 5, 0}).distance, 3);
    EXPECT_DOUBLE_EQ(nearest_surface(ball, {}).distance, -2);
    EXPECT_DOUBLE_EQ(length(nearest_surface(ball, {}).normal), 1);
}

TEST(Contact, TooLittleRoomIsReported) {
    Dropped dropped(block());
    dropped.room.resize(5);
    dropped.body.set_velocities([](Vec3f) { return Vec3f{0, -5, 0}; });
    const Obstacle floor = floor_at(-0.01);
    const InstanceReport report = dropped.step({&floor, 1});
    EXPECT_EQ(report.contacts, 5u);
    EXPECT_TRUE(report.is_room_too_small);
}

// A strike gives all its momentum and its turning to free nodes.
TEST(Contact, AStrikeGivesItsMomentum) {
    Dropped dropped(block());
    const Vec3f at{0.31f, 0.6f, 0.22f};
    const Vec3f blow{3, -20, 5};
    strike(dropped.body.model, dropped.body.state, at, blow);
    const Vec3 p = linear_momentum(dropped.body.model, dropped.body.state);
    const Vec3 l = angular_momentum(dropped.body.model, dropped.body.state);
    const Vec3f turning = cross(at, blow);
    EXPECT_LT(length(p - Vec3{3, -20, 5}), 1e-4);
    EXPECT_LT(length(l - Vec3{turning.x, turning.y, turning.z}), 1e-3);
}

}
