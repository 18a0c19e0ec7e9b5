// SPDX-License-Identifier: MIT
// Items of the accuracy test-bed whose answer is known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/body.h"
#include "solver/effort.h"

namespace crumple::solver::test {
namespace {

Settings exact(RotationMethod rotation = RotationMethod::apd) {
    Settings settings;
    settings.rotation = rotation;
    settings.max_iterations = 3000;
    settings.tolerance = 1e-7;
    return settings;
}

std::vector<Constraint> all_fixed(const Body& body) {
    std::vector<Constraint> all;
    for (Index i = 0; i < body.node_count(); ++i) all.push_back({i, ConstraintKind::fixed, {}, {}, {}});
    return all;
}

// The force the body pulls each node with where it is: minus what holds all of them.
std::vector<Vec3f> pull_of(Body& body) {
    const auto all = all_fixed(body);
    std::vector<Vec3f> reactions(body.node_count());
    StepInput input;
    input.constraints = all;
    input.reactions = reactions;
    body.step(input);
    for (Vec3f& r : reactions) r = -r;
    return reactions;
}

double net_torque(const Body& body, const std::vector<Vec3f>& forces) {
    Vec3 torque;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const Vec3f x = body.x(i);
        torque += cross(Vec3{x.x, x.y, x.z}, Vec3{forces[i].x, forces[i].y, forces[i].z});
    }
    return length(torque);
}

}

TEST(A2RigidRotation, ATurnedBodyFeelsNoForce) {
    Rng rng(1);
    for (int i = 0; i < 20; ++i) {
        Body body(grid_body({2, 2, 2}, {0.5f, 0.5f, 0.5f}, elastic_material(1e5)), exact());
        const Mat3 r = random_rotation(rng);
        body.set_positions([&](Vec3f p) { return r * p; });
        const double cell_area = std::pow(body.bundle.volume[0], 2.0 / 3);
        // Positions of size 1 rounded to float over edges of 0.5 leave strains of 1e-7 or so in each of 24 tets.
        for (const Vec3f f : pull_of(body)) EXPECT_LT(length(f), 5e-5 * 1e5 * cell_area);
    }
}

// A8. Elements push and pull in pairs, so momentum stays; R^T F symmetric means no torque, which QR does not give.
TEST(A8Momentum, LinearMomentumStaysAndAngularDriftHalvesWithDt) {
    std::vector<double> drift;
    // A tenth of a second, in which even the largest step leaves the vibration (period .1 s) alive.
    for (const double dt : {0.002, 0.001, 0.0005}) {
        Body body(grid_body({2, 2, 2}, {0.5f, 0.5f, 0.5f}, elastic_material(1e5)), exact());
        body.set_velocities([](Vec3f p) {
            return Vec3f{0.5f - p.y, p.x - 0.5f, 0} * 2.0f + Vec3f{p.x - 0.5f, 0, 0.2f};
        });
        double size = 0;
        for (std::size_t i = 0; i < body.node_count(); ++i) {
            size += body.bundle.mass[i] * static_cast<double>(length(velocity(body.state, i)));
        }
        const Vec3 linear = linear_momentum(body.model, body.state);
        const Vec3 angular = angular_momentum(body.model, body.state);
        const int steps = static_cast<int>(std::lround(0.1 / dt));
        for (int i = 0; i < steps; ++i) body.step(static_cast<float>(dt));
        EXPECT_LT(length(linear_momentum(body.model, body.state) - linear), 1e-6 * size) << dt;
        drift.push_back(length(angular_momentum(body.model, body.state) - angular));
    }
    EXPECT_LT(drift[1], 0.65 * drift[0]);
    EXPECT_LT(drift[2], 0.65 * drift[1]);
}

TEST(A8Momentum, LinearMomentumStaysForAThousandSteps) {
    Body body(grid_body({2, 2, 2}, {0.5f, 0.5f, 0.5f}, elastic_material(1e5)), exact());
    Rng rng(8);
    body.set_velocities([&](Vec3f) { return random_vector(rng); });
    double size = 0;
    for (std::size_t i = 0; i < body.node_count(); ++i) {
        size += body.bundle.mass[i] * static_cast<double>(length(velocity(body.state, i)));
    }
    const Vec3 before = linear_momentum(body.model, body.state);
    for (int i = 0; i < test::effort(1000, 1000, 50); ++i) body.step(0.005f);
    EXPECT_LT(length(linear_momentum(body.model, body.state) - before), 1e-6 * size);
}

TEST(A8Momentum, PolarRotationsGiveNoTorqueAndQrDoes) {
    for (const RotationMethod rotation :
         {RotationMethod::apd, RotationMethod::polar, RotationMethod::svd_smallest, RotationMethod::qr}) {
        Rng rng(3);
        Body body(grid_body({2, 2, 2}, {0.5f, 0.5f, 0.5f}, elastic_material(1e5)), exact(rotation));
        body.set_positions([&](Vec3f p) { return p + random_vector(rng) * 0.08f; });
        const double torque = net_torque(body, pull_of(body));
        if (rotation == RotationMethod::qr) {
            EXPECT_GT(torque, 1e-3 * 1e5);
        } else {
            EXPECT_LT(torque, 1e-5 * 1e5) << name_of(rotation);
        }
    }
}

TEST(A9Compression, StressIsThatOfHookeUniaxialAndConfined) {
    const double young = 1e6, poisson = 0.3;
    const double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
    const double mu = young / (2 * (1 + poisson));
    for (const double strain : {-0.05, 0.05, 0.2}) {
        for (const bool is_confined : {true, false}) {
            Body body(grid_body({1, 1, 1}, {1, 1, 1}, elastic_material(young, poisson)), exact());
            const double side = is_confined ? 0 : -poisson * strain;
            body.set_positions([&](Vec3f p) {
                return Vec3f{static_cast<float>(p.x * (1 + strain)), static_cast<float>(p.y * (1 + side)),
                             static_cast<float>(p.z * (1 + side))};
            });
            const auto pull = pull_of(body);
            double force = 0, sideways = 0;
            for (std::size_t i = 0; i < body.node_count(); ++i) {
                if (body.rest(i).x == 1) force -= pull[i].x;
                if (body.rest(i).y == 1) sideways -= pull[i].y;
            }
            const double expected = (is_confined ? lambda + 2 * mu : young) * strain;
            EXPECT_NEAR(force, expected, 1e-5 * std::fabs(expected)) << strain;
            EXPECT_NEAR(sideways, is_confined ? lambda * strain : 0, 2e-5 * std::fabs(expected)) << strain;
        }
    }
}

}
