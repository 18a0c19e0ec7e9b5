// SPDX-License-Identifier: MIT
#include "solver/skin.h"

#include <gtest/gtest.h>

#include "solver/body.h"
#include "solver/sensor.h"

namespace crumple::solver::test {
namespace {

using Four = std::array<float, 4>;

// Vertices on random places of random tets, with orthogonal normals and tangents.
struct Drawn {
    Drawn(const Bundle& bundle, std::size_t count) {
        Rng rng(13);
        for (std::size_t i = 0; i < count; ++i) {
            tet.push_back(rng.next_below(static_cast<std::uint32_t>(bundle.tets.size())));
            Four w{};
            float sum = 0;
            for (float& value : w) sum += value = static_cast<float>(rng.next_unit()) + 1e-3f;
            for (float& value : w) value /= sum;
            weights.push_back(w);
            const Mat3 r = random_rotation(rng);
            rest_normals.push_back(r.column(0));
            rest_tangents.push_back({r(0, 1), r(1, 1), r(2, 1), -1});
        }
        positions.resize(count);
        normals.resize(count);
        tangents.resize(count);
        view = {bundle.tets, tet, weights};
    }
    void skin(const Body& body, VertexRange range, const Settings& settings = {}) {
        solver::skin(body.model, body.state, view, {rest_normals, rest_tangents}, {positions, normals, tangents}, range,
                     settings);
    }
    [[nodiscard]] Vec3f rest(const Body& body, std::size_t v) const {
        Vec3f sum;
        for (std::size_t i = 0; i < 4; ++i) sum += body.rest(view.tets[tet[v]][i]) * weights[v][i];
        return sum;
    }
    std::vector<Index> tet;
    std::vector<Four> weights;
    std::vector<Vec3f> rest_normals, positions, normals;
    std::vector<Four> rest_tangents, tangents;
    VisualView view;
};

Bundle bar() {
    return grid_body({6, 2, 2}, {0.3f, 0.3f, 0.3f}, elastic_material(), [](Vec3f p) { return p.x < 0.4f; });
}

Vec3f xyz(const Four& a) { return {a[0], a[1], a[2]}; }

}

// A13: an affine map of the nodes maps drawn vertices alike, and normals by its rotation.
TEST(A13Skinning, AnAffineMapIsFollowedExactly) {
    for (const Isa isa : {Isa::scalar, Isa::automatic}) {
        Settings settings;
        settings.isa = isa;
        Bundle free = bar();
        free.locked.assign(free.locked.size(), 0);
        Body body(bundle_of(free.rest_positions, free.tets, elastic_material()), settings);
        Drawn drawn(body.bundle, 500);
        const Mat3 r = turn({1, 2, 3}, 0.8);
        const Mat3 map = r * Mat3{{1.1f, 0.05f, 0, 0.05f, 0.9f, 0, 0, 0, 1.05f}};
        body.set_positions([&](Vec3f p) { return map * p + Vec3f{1, 2, 3}; });
        // A step of no time to speak of leaves the positions and finds the rotations.
        body.step(1e-9f);
        drawn.skin(body, {0, 500}, settings);
        for (std::size_t v = 0; v < 500; ++v) {
            EXPECT_LT(length(drawn.positions[v] - (map * drawn.rest(body, v) + Vec3f{1, 2, 3})), 1e-5f);
            EXPECT_LT(length(drawn.normals[v] - r * drawn.rest_normals[v]), 1e-5f);
            EXPECT_LT(std::abs(dot(drawn.normals[v], xyz(drawn.tangents[v]))), 1e-5f);
            EXPECT_NEAR(length(drawn.normals[v]), 1, 1e-5);
            EXPECT_EQ(drawn.tangents[v][3], -1);
        }
    }
}

// The rotations are those at the positions of now, not of a step ago.
TEST(A13Skinning, NormalsKeepUpWithAFastTurn) {
    Bundle loose = bar();
    Body body(bundle_of(loose.rest_positions, loose.tets, elastic_material(1e6)));
    Drawn drawn(body.bundle, 100);
    body.set_velocities([](Vec3f p) { return cross(Vec3f{0, 6, 0}, p - Vec3f{0.9f, 0.3f, 0.3f}); });
    for (int i = 0; i < 10; ++i) body.step(1.0f / 60);
    drawn.skin(body, {0, 100});
    for (std::size_t v = 0; v < 100; ++v) {
        const Mat3 f = deformation_gradient(body.model, body.state, drawn.tet[v]);
        const Mat3 r = rotation_svd_smallest(f, Mat3::identity());
        EXPECT_LT(length(drawn.normals[v] - r * drawn.rest_normals[v]), 1e-4f);
    }
}

TEST(Skinning, LockedTetsAreDrawnWhereTheyWere) {
    Body body(bar());
    ASSERT_LT(body.model.tet_count, body.bundle.tets.size());
    Drawn drawn(body.bundle, 300);
    StepInput input;
    input.gravity = {0, -9.81f, 0};
    for (int i = 0; i < 10; ++i) body.step(input);
    drawn.skin(body, {0, 300});
    for (std::size_t v = 0; v < 300; ++v) {
        if (drawn.tet[v] < body.model.tet_count) continue;
        EXPECT_LT(length(drawn.positions[v] - drawn.rest(body, v)), 1e-6f);
        EXPECT_EQ(drawn.normals[v], drawn.rest_normals[v]);
    }
}

TEST(Skinning, OnlyTheRangeIsWritten) {
    Body body(bar());
    Drawn drawn(body.bundle, 50);
    drawn.skin(body, {10, 20});
    EXPECT_EQ(drawn.positions[9], Vec3f{});
    EXPECT_FALSE(drawn.positions[10] == Vec3f{});
    EXPECT_FALSE(drawn.positions[19] == Vec3f{});
    EXPECT_EQ(drawn.positions[20], Vec3f{});
    drawn.skin(body, {40, 5000});
    EXPECT_FALSE(drawn.positions[49] == Vec3f{});
}

TEST(Skinning, SaysWhichVerticesMoved) {
    Body body(bar());
    Drawn drawn(body.bundle, 200);
    EXPECT_EQ(moved_vertices(body.model, body.state, drawn.view, 1e-4f), VertexRange{});
    set_velocity(body.state, body.node_count() - 1, {1, 1, 0});
    body.step(1.0f / 600);
    const VertexRange range = moved_vertices(body.model, body.state, drawn.view, 1e-4f);
    ASSERT_LT(range.first, range.last);
    const auto near_end = [&](std::size_t v) { return body.rest(drawn.view.tets[drawn.tet[v]][0]).x > 0.4f; };
    EXPECT_TRUE(near_end(range.first));
    EXPECT_TRUE(near_end(range.last - 1));
    forget_moves(body.state);
    EXPECT_EQ(moved_vertices(body.model, body.state, drawn.view, 1e-4f), VertexRange{});
}

TEST(Skinning, AViewThatLiesIsFound) {
    const Bundle bundle = bar();
    Drawn drawn(bundle, 20);
    const std::size_t nodes = bundle.rest_positions.size();
    EXPECT_EQ(first_problem(drawn.view, nodes), nullptr);
    EXPECT_NE(first_problem(drawn.view, nodes - 1), nullptr);
    drawn.tet[3] = static_cast<Index>(bundle.tets.size());
    EXPECT_NE(first_problem(drawn.view, nodes), nullptr);
    drawn.tet[3] = 0;
    drawn.weights[3][1] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(first_problem(drawn.view, nodes), nullptr);
    drawn.weights.pop_back();
    drawn.view.barycentric = drawn.weights;
    EXPECT_NE(first_problem(drawn.view, nodes), nullptr);
}

namespace {

BundleSensor sensor_on(const Body& body, const std::function<bool(Vec3f)>& is_in) {
    BundleSensor s;
    for (Index n = 0; n < body.node_count(); ++n) {
        if (is_in(body.rest(n))) s.node.push_back(n);
    }
    for (const Index n : s.node) {
        s.weight.push_back(1.0f / static_cast<float>(s.node.size()));
        s.rest_origin += body.rest(n) * s.weight[0];
    }
    s.rest_axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    return s;
}

Body loose_bar() {
    const Bundle b = bar();
    return Body(bundle_of(b.rest_positions, b.tets, elastic_material()));
}

}

// A14: the frame of a cluster moved rigidly, with noise, and of flat and straight clusters.
TEST(A14Sensor, FollowsARigidMove) {
    const std::function<bool(Vec3f)> clusters[] = {[](Vec3f) { return true; }, [](Vec3f p) { return p.y == 0; },
                                                   [](Vec3f p) { return p.y == 0 && p.z == 0; }};
    for (const auto& is_in : clusters) {
        Body body = loose_bar();
        const BundleSensor sensor = sensor_on(body, is_in);
        SensorMemory memory;
        const bool is_line = sensor.node.size() < 8;
        for (int i = 1; i <= 40; ++i) {
            // On a line only turns across it can be seen.
            const Mat3 r = turn(is_line ? Vec3f{0, 0, 1} : Vec3f{1, 2, 3}, 0.07 * i);
            body.set_positions([&](Vec3f p) { return r * p + Vec3f{1, 2, 3}; });
            const SensorReading reading = read_sensor(body.model, body.state, view_of(sensor), memory, 0.01f);
            EXPECT_LT(norm(to_matrix(reading.orientation) - r), 1e-5f) << sensor.node.size();
            EXPECT_LT(length(reading.origin - (r * sensor.rest_origin + Vec3f{1, 2, 3})), 1e-5f);
            EXPECT_LT(reading.deformation, 1e-4f);
        }
    }
}

TEST(A14Sensor, NoiseBarelyTurnsItAndAMirrorImageNeverMirrorsIt) {
    Body body = loose_bar();
    const BundleSensor sensor = sensor_on(body, [](Vec3f) { return true; });
    Rng rng(14);
    SensorMemory memory;
    body.set_positions([&](Vec3f p) { return p + random_vector(rng) * 0.01f; });
    const SensorReading noisy = read_sensor(body.model, body.state, view_of(sensor), memory, 0);
    EXPECT_LT(norm(to_matrix(noisy.orientation) - Mat3::identity()), 0.02f);
    EXPECT_GT(noisy.deformation, 1e-4f);
    body.set_positions([](Vec3f p) { return Vec3f{p.x, p.y, -p.z}; });
    const SensorReading mirrored = read_sensor(body.model, body.state, view_of(sensor), memory, 0);
    EXPECT_NEAR(determinant(to_matrix(mirrored.orientation)), 1, 1e-5);
    EXPECT_GT(mirrored.deformation, 1);
}

// Of a cluster that is as wide in all directions, a stretch along any axes is no turn.
TEST(A14Sensor, AffineNoiseDoesNotTurnIt) {
    Body body = loose_bar();
    const BundleSensor sensor = sensor_on(body, [](Vec3f p) { return p.x < 0.7f; });
    ASSERT_EQ(sensor.node.size(), 27u);
    Rng rng(15);
    for (int i = 0; i < 50; ++i) {
        const Vec3f a = random_vector(rng);
        const Vec3f b = random_vector(rng);
        const Mat3 stretch = Mat3::identity() + (outer(a, a) + outer(b, b)) * 0.02f;
        const Mat3 r = random_rotation(rng);
        body.set_positions([&](Vec3f p) { return r * (stretch * p); });
        SensorMemory memory;
        const SensorReading reading = read_sensor(body.model, body.state, view_of(sensor), memory, 0);
        EXPECT_LT(norm(to_matrix(reading.orientation) - r), 1e-5f) << i;
        EXPECT_LT(length(reading.origin - r * (stretch * sensor.rest_origin)), 1e-6f * 1.8f) << i;
    }
}

TEST(Sensor, MeasuresAccelerationAndPlasticStrain) {
    Material m = elastic_material(1e6);
    m.yield_pa = 1e3;
    const Bundle b = bar();
    Body body(bundle_of(b.rest_positions, b.tets, m));
    const BundleSensor sensor = sensor_on(body, [](Vec3f p) { return p.x > 1; });
    SensorMemory memory;
    StepInput input;
    input.gravity = {0, -9.81f, 0};
    read_sensor(body.model, body.state, view_of(sensor), memory, 0);
    body.step(input);
    const SensorReading falling = read_sensor(body.model, body.state, view_of(sensor), memory, input.dt);
    EXPECT_NEAR(falling.acceleration.y, -9.81, 1e-3);
    EXPECT_EQ(falling.plastic_strain, 0);
    set_velocity(body.state, body.node_count() - 1, {10, 0, 0});
    for (int i = 0; i < 10; ++i) body.step(input);
    EXPECT_GT(read_sensor(body.model, body.state, view_of(sensor), memory, input.dt).plastic_strain, 1e-4f);
}

namespace {

// About z, under way.
CarrierMotion spinning(double angle, double rate) {
    CarrierMotion carrier;
    carrier.position = {100, 200, 300};
    carrier.velocity = {30, -20, 10};
    carrier.orientation = to_quaternion(turn({0, 0, 1}, angle));
    carrier.angular_velocity = {0, 0, rate};
    return carrier;
}

}

TEST(Sensor, OnASpinningCarrierFeelsTheCentripetalPull) {
    Body body = loose_bar();
    const BundleSensor tip = sensor_on(body, [](Vec3f p) { return p.x > 1; });
    const Vec3f arm{tip.rest_origin.x, tip.rest_origin.y, 0};
    constexpr float rate = 5;
    constexpr float dt = 1.0f / 1000;
    SensorMemory memory;
    for (int i = 0; i < 100; ++i) {
        const float angle = 0.3f + rate * dt * static_cast<float>(i);
        const SensorReading r = read_sensor(body.model, body.state, view_of(tip), memory, dt,
                                            spinning(static_cast<double>(angle), static_cast<double>(rate)));
        if (i == 0) continue;
        // Half a step ago, seen along the axes of now: rate dt / 2 off.
        EXPECT_LT(length(r.acceleration + arm * (rate * rate)), rate * dt * rate * rate * length(arm)) << i;
    }
}

// Coriolis, Euler and centripetal parts cancel.
TEST(Sensor, WhatFliesStraightFeelsNothingWhileItsCarrierTurnsFasterAndFaster) {
    Body body = loose_bar();
    const BundleSensor sensor = sensor_on(body, [](Vec3f) { return true; });
    constexpr double dt = 1.0 / 240;
    SensorMemory memory;
    const Vec3 v{1, 2, 3};
    for (int i = 0; i < 60; ++i) {
        const double t = dt * i;
        CarrierMotion carrier = spinning(2 * t + 3 * t * t, 2 + 6 * t);
        carrier.position = {};
        carrier.velocity = {};
        const solver::Frame frame(carrier);
        body.set_positions([&](Vec3f p) { return frame.point(widen(p) + v * t); });
        body.set_velocities([&](Vec3f p) { return frame.velocity(widen(p) + v * t, v); });
        const SensorReading r =
            read_sensor(body.model, body.state, view_of(sensor), memory, static_cast<float>(dt), carrier);
        EXPECT_GT(length(r.velocity), 3);
        // Float keeps 1e-6 of velocities of some m/s, and dt divides their difference.
        EXPECT_LT(length(r.acceleration), 3e-3f) << i;
    }
}

TEST(Sensor, ATriggerHasHysteresis) {
    SensorMemory memory;
    const float values[] = {0, 0.6f, 1, 0.7f, 0.5f, 0.4f, 0.9f, 1.2f};
    const bool went_on[] = {false, false, true, false, false, false, false, true};
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(trigger(memory, values[i], 1, 0.5f), went_on[i]) << i;
}

TEST(Sensor, AViewThatLiesIsFound) {
    Body body = loose_bar();
    BundleSensor sensor = sensor_on(body, [](Vec3f) { return true; });
    EXPECT_EQ(first_problem(view_of(sensor), body.node_count()), nullptr);
    EXPECT_NE(first_problem(view_of(sensor), 5), nullptr);
    EXPECT_NE(first_problem(SensorView{}, 5), nullptr);
    sensor.weight[1] = -1;
    EXPECT_NE(first_problem(view_of(sensor), body.node_count()), nullptr);
}

}
