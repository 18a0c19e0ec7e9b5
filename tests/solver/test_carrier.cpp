// SPDX-License-Identifier: MIT
// Bodies that ride on a rigid body which they push in turn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/body.h"
#include "solver/instance.h"
#include "solver/outside.h"
#include "solver/sensor.h"

namespace crumple::solver::test {
namespace {

Vec3 widen(Vec3f a) { return {a.x, a.y, a.z}; }

Material dented() {
    Material m = elastic_material(2e6);
    m.yield_pa = 5e4;
    m.creep_per_s = 60;
    m.alpha_per_s = 0.15;
    m.beta_s = 0.004;
    return m;
}

// A bumper in front of (x < 0) a locked block, around the origin.
Bundle bumper(const Material& material, float locked_from = 0.2f) {
    Bundle b = grid_body({6, 3, 3}, {0.3f, 0.3f, 0.3f}, material);
    for (Vec3f& p : b.rest_positions) p -= Vec3f{0.9f, 0.45f, 0.45f};
    return bundle_of(b.rest_positions, b.tets, material, [=](Vec3f p) { return p.x > locked_from; });
}

Settings with(Plasticity plasticity) {
    Settings settings;
    settings.plasticity = plasticity;
    return settings;
}

// A body on the simplest rigid body: that of its own mass, turning only where `turns`.
struct Rider {
    explicit Rider(Bundle bundle, bool may_turn = false, Plasticity plasticity = Plasticity::additive)
        : body(std::move(bundle), with(plasticity)), turns(may_turn) {
        for (std::size_t i = 0; i < body.node_count(); ++i) {
            const double m = body.bundle.mass[i];
            const Vec3 r = widen(body.rest(i));
            mass += m;
            inertia = inertia + (Mat3d::identity() * dot(r, r) - outer(r, r)) * m;
        }
        room.resize(body.node_count());
    }

    InstanceReport step(InstanceInput input) {
        input.carrier = motion;
        input.room = room;
        const InstanceReport report = step_instance(body.model, body.state, body.workspace, input, body.settings);
        const double dt = static_cast<double>(input.dt);
        motion.acceleration = report.load.force / mass;
        motion.velocity += motion.acceleration * dt;
        motion.position += motion.velocity * dt;
        if (turns) turn(report.load.torque, dt);
        return report;
    }
    // Takes the torque, then turns by the new velocity: angular momentum is kept in the world.
    void turn(Vec3 torque, double dt) {
        const Mat3d then = world(inertia);
        const Vec3 before = motion.angular_velocity;
        const Vec3 spinning = then * before + torque * dt;
        motion.angular_velocity = transpose(cofactor(then)) * spinning / determinant(then);
        const double angle = length(motion.angular_velocity) * dt;
        if (angle > 0) {
            const Vec3 n = motion.angular_velocity * (std::sin(angle / 2) / (angle / dt));
            const Quaternion by{static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z),
                                static_cast<float>(std::cos(angle / 2))};
            motion.orientation = to_quaternion(to_matrix(by) * to_matrix(motion.orientation));
        }
        const Mat3d now = world(inertia);
        motion.angular_velocity = transpose(cofactor(now)) * spinning / determinant(now);
        motion.angular_acceleration = (motion.angular_velocity - before) / dt;
    }
    [[nodiscard]] Mat3d world(const Mat3d& a) const {
        const Mat3 r = to_matrix(motion.orientation);
        Mat3d wide;
        for (std::size_t i = 0; i < 9; ++i) wide.m[i] = r.m[i];
        return wide * a * transpose(wide);
    }
    // Of all mass where it is, seen from the world: momentum, and angular momentum about its centre.
    [[nodiscard]] Six whole() const {
        Six sum{};
        const Frame frame(motion);
        const Vec3 middle = centre();
        for (std::size_t i = 0; i < body.node_count(); ++i) {
            const Vec3 arm = frame.to_world(widen(body.x(i)));
            const Vec3 v =
                motion.velocity + cross(motion.angular_velocity, arm) + frame.to_world(widen(velocity(body.state, i)));
            add_to(sum, static_cast<double>(body.bundle.mass[i]), push_at(motion.position + arm - middle, v));
        }
        return sum;
    }
    [[nodiscard]] Vec3 centre() const {
        Vec3 sum;
        for (std::size_t i = 0; i < body.node_count(); ++i) {
            sum += Frame(motion).point_to_world(body.x(i)) * static_cast<double>(body.bundle.mass[i]);
        }
        return sum / mass;
    }
    [[nodiscard]] Vec3 momentum() const { return linear_part(whole()); }
    [[nodiscard]] Vec3 spin() const { return angular_part(whole()); }
    // Of carrier and nodes together, seen from the world.
    [[nodiscard]] double energy() const {
        double kinetic = 0;
        const Frame frame(motion);
        for (std::size_t i = 0; i < body.node_count(); ++i) {
            const Vec3 arm = frame.to_world(widen(body.x(i)));
            const Vec3 v =
                motion.velocity + cross(motion.angular_velocity, arm) + frame.to_world(widen(velocity(body.state, i)));
            kinetic += 0.5 * body.bundle.mass[i] * dot(v, v);
        }
        return kinetic + elastic_energy(body.model, body.state, EnergyRotation::of_state);
    }
    [[nodiscard]] double deepest_dent() const {
        double deepest = 0;
        for (std::size_t i = 0; i < body.node_count(); ++i) {
            deepest = std::max(deepest, static_cast<double>(length(body.x(i) - body.rest(i))));
        }
        return deepest;
    }

    Body body;
    CarrierMotion motion;
    bool turns;
    double mass = 0;
    Mat3d inertia;
    std::vector<Constraint> room;
};

InstanceInput in_space() {
    InstanceInput input;
    input.gravity = {};
    input.may_sleep = false;
    return input;
}

// Into a wall at 15 m/s, the whole scene moved, turned and under way.
Rider crash(Vec3 place, Vec3 under_way, Quaternion orientation, bool has_inertia = false) {
    Rider rider(bumper(dented()));
    rider.motion.orientation = orientation;
    CarrierMotion start;
    start.orientation = orientation;
    const Frame turn(start);
    rider.motion.position = place;
    rider.motion.velocity = under_way + turn.to_world({-15, 0, 0});
    Obstacle wall;
    wall.axis = turn.to_world({1, 0, 0});
    wall.position = place + turn.to_world({-1, 0, 0});
    wall.velocity = under_way;
    for (int i = 0; i < 60; ++i) {
        InstanceInput input = in_space();
        input.has_inertia = has_inertia;
        input.is_carrier_free = !has_inertia;
        input.obstacles = {&wall, 1};
        rider.step(input);
        wall.position += under_way * static_cast<double>(input.dt);
    }
    return rider;
}

double farthest(const Body& a, const Body& b) {
    double far = 0;
    for (std::size_t i = 0; i < a.node_count(); ++i) far = std::max(far, static_cast<double>(length(a.x(i) - b.x(i))));
    return far;
}

constexpr Quaternion upright{};
const Quaternion leaning = to_quaternion(turn({1, 2, 3}, 0.7));

}

class CarrierInertia : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Forces, CarrierInertia, testing::Bool(),
                         [](const auto& parameter) { return std::string(parameter.param ? "on" : "off"); });

TEST_P(CarrierInertia, TheSameCrashLeavesTheSameDentsAnywhere) {
    const Rider here = crash({}, {}, upright, GetParam());
    EXPECT_GT(here.deepest_dent(), 0.1);
    constexpr double size = 1.8;
    EXPECT_LT(farthest(here.body, crash({6000, 0, 8000}, {}, upright, GetParam()).body), 1e-4 * size);
    EXPECT_LT(farthest(here.body, crash({}, {0, 0, 100}, upright, GetParam()).body), 1e-4 * size);
    EXPECT_LT(farthest(here.body, crash({}, {-100, 0, 0}, upright, GetParam()).body), 1e-4 * size);
    EXPECT_LT(farthest(here.body, crash({10000, 0, 0}, {-60, 0, 80}, leaning, GetParam()).body), 1e-4 * size);
}

// The engine block is locked: in the frame it never moves, in the world it takes the whole crash.
TEST(Carrier, ASensorOnALockedBlockReadsTheCarriersDeceleration) {
    Rider rider(bumper(dented()), true);
    rider.motion.orientation = leaning;
    const Frame start(rider.motion);
    const Vec3 ahead = start.to_world({-1, 0, 0});
    rider.motion.velocity = ahead * 15;
    Obstacle wall;
    wall.axis = ahead * -1;
    wall.position = ahead;
    BundleSensor block;
    for (Index i = 0; i < rider.body.node_count(); ++i) {
        if (rider.body.bundle.locked[i]) block.node.push_back(i);
    }
    block.weight.assign(block.node.size(), 1 / static_cast<float>(block.node.size()));
    block.rest_axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    SensorMemory memory;
    InstanceInput input = in_space();
    input.obstacles = {&wall, 1};
    const auto read = [&] {
        return read_sensor(rider.body.model, rider.body.state, view_of(block), memory, input.dt, rider.motion);
    };
    const Vec3 last = rider.motion.velocity;
    read();
    Vec3 gained;
    float hardest = 0;
    for (int i = 0; i < 60; ++i) {
        rider.step(input);
        const SensorReading r = read();
        hardest = std::max(hardest, length(r.acceleration));
        gained += Frame(rider.motion).to_world(widen(r.acceleration)) * static_cast<double>(input.dt);
        EXPECT_EQ(length(r.velocity), 0);
    }
    EXPECT_GT(hardest, 100);
    // The block's middle lies 0.6 m behind the origin and turns little, but it turns.
    const Frame end(rider.motion);
    const Vec3 middle = end.to_world({0.6, 0, 0});
    EXPECT_LT(length(gained - (rider.motion.velocity + cross(rider.motion.angular_velocity, middle) - last)), 1e-3);
    EXPECT_LT(dot(rider.motion.velocity, ahead), 5);
}

TEST(Carrier, LockedNodesStandStillInTheFrame) {
    const Rider rider = crash({}, {-100, 0, 0}, upright);
    for (std::size_t i = 0; i < rider.body.node_count(); ++i) {
        if (rider.body.bundle.locked[i]) {
            EXPECT_EQ(rider.body.x(i), rider.body.rest(i));
        }
    }
}

// A game that stands still.
TEST(Carrier, AStepOfNoTimeDoesNothingAndHasNoLoad) {
    const Hit blow{{-0.9, 0, 0}, {100, 0, 0}};
    for (const float dt : {0.0f, -1.0f, std::nanf("")}) {
        Rider rider(bumper(dented()));
        const std::vector<float> before(rider.body.state.velocities.begin(), rider.body.state.velocities.end());
        InstanceInput input = in_space();
        input.dt = dt;
        input.hits = {&blow, 1};
        const InstanceReport report = rider.step(input);
        EXPECT_EQ(report.step.warnings, static_cast<std::uint32_t>(step_bad_input));
        EXPECT_EQ(report.load.force, Vec3{});
        EXPECT_EQ(report.load.torque, Vec3{});
        EXPECT_TRUE(std::equal(before.begin(), before.end(), rider.body.state.velocities.begin()));
    }
}

// Nothing but the wall's push changes the momentum of carrier and nodes together.
TEST(Carrier, ACrashKeepsTheMomentumOfBodyAndDeformation) {
    Rider rider(bumper(dented()), true);
    rider.motion.velocity = {-15, 2, 1};
    Obstacle wall;
    wall.axis = {1, 0, 0};
    wall.position = {-1, 0, 0};
    Six expected = rider.whole();
    const double size = length(linear_part(expected));
    for (int i = 0; i < 120; ++i) {
        InstanceInput input = in_space();
        input.obstacles = {&wall, 1};
        const CarrierMotion before = rider.motion;
        const Vec3 centre = rider.centre();
        const StepReport given = rider.step(input).step;
        const Vec3 push = Frame(before).to_world(given.impulse);
        const Vec3 torque = Frame(before).to_world(given.angular_impulse) + cross(before.position - centre, push);
        add_to(expected, 1, {push.x, push.y, push.z, torque.x, torque.y, torque.z});
        EXPECT_LT(length(rider.momentum() - linear_part(expected)), 1e-4 * size) << i;
        // 1e-4 is wanted. The bumper is crushed by half its length, at 60 steps a second: 1.44e-4.
        EXPECT_LT(length(rider.spin() - angular_part(expected)), 1.5e-4 * size * 1.8) << i;
    }
    EXPECT_GT(rider.motion.velocity.x, -5);  // it did hit
}

// As stiff as a car: what conjugate gradients do not find in their budget must not be made up for by the wall.
Material stiff_as_a_car() {
    Material m = dented();
    m.young_pa = 2e8;
    m.yield_pa = 2.5e6;
    m.density_kg_m3 = 180;
    return m;
}

enum class Into { wall, pole };

struct CrashEnd {
    double most = 0;   // energy at any time, of that at the start
    double rises = 0;  // the largest rise within a step, of that at the start
    double dent = 0;   // m
    Vec3 velocity, angular_velocity;
};

CrashEnd crash_stiff(Into what, std::uint32_t iterations, double rate, Material material = stiff_as_a_car(),
                     Plasticity plasticity = Plasticity::additive) {
    Rider rider(bumper(material), true, plasticity);
    rider.body.settings.max_iterations = iterations;
    rider.motion.velocity = {-15, 0, 0};
    Obstacle obstacle;
    obstacle.axis = {1, 0, 0};
    obstacle.position = {-1, 0, 0};
    if (what == Into::pole) {
        obstacle.shape = ObstacleShape::capsule;
        obstacle.radius = 0.1;
        obstacle.axis = {0, 3, 0};
        obstacle.position = {-1.1, 0, 0.1};
    }
    const double start = rider.energy();
    CrashEnd end;
    double last = start;
    for (int i = 0; i < static_cast<int>(rate / 2); ++i) {
        InstanceInput input = in_space();
        input.dt = static_cast<float>(1 / rate);
        input.obstacles = {&obstacle, 1};
        rider.step(input);
        const double now = rider.energy();
        end.most = std::max(end.most, now / start);
        end.rises = std::max(end.rises, (now - last) / start);
        last = now;
    }
    end.dent = rider.deepest_dent();
    end.velocity = rider.motion.velocity;
    end.angular_velocity = rider.motion.angular_velocity;
    return end;
}

// Nothing works from outside: the obstacle stands still.
TEST(Carrier, CarrierAndBodyNeverGainEnergyAtAnyBudget) {
    for (const Into what : {Into::wall, Into::pole}) {
        for (const double rate : {60.0, 120.0, 480.0}) {
            for (const std::uint32_t iterations : {1u, 5u, 20u, 100u}) {
                const CrashEnd end = crash_stiff(what, iterations, rate);
                EXPECT_LE(end.most, 1.0001) << rate << " " << iterations;
                EXPECT_LE(end.rises, 0.01) << rate << " " << iterations;
                EXPECT_GT(end.velocity.x, -1) << rate << " " << iterations;
                EXPECT_LT(end.velocity.x, 8) << rate << " " << iterations;
            }
        }
    }
}

TEST(Carrier, TwentyIterationsDentLikeFourHundred) {
    Material m = stiff_as_a_car();
    m.young_pa = 2e7;
    m.yield_pa = 5e4;
    m.creep_per_s = 600;
    m.beta_s = 1e-4;
    for (const Into what : {Into::wall, Into::pole}) {
        const CrashEnd some = crash_stiff(what, 20, 240, m);
        const CrashEnd many = crash_stiff(what, 400, 240, m);
        EXPECT_GT(many.dent, 0.005);
        EXPECT_NEAR(some.dent, many.dent, 0.1 * many.dent);
        EXPECT_LT(length(some.velocity - many.velocity), 0.5);
    }
}

// What yields within a step pushes back with what the flow leaves, and of a strain that goes on the flow leaves the
// same whatever dt, so dents settle as dt falls. A longer step is short of that by about half its way, as implicit
// Euler is: 3 cm at 240 Hz.
TEST(Carrier, DentsSettleAsStepsGetShorter) {
    Material m = stiff_as_a_car();
    m.young_pa = 6e6;
    m.yield_pa = 8e4;
    m.creep_per_s = 600;
    m.beta_s = 4e-4;
    for (const Plasticity plasticity : {Plasticity::additive, Plasticity::multiplicative}) {
        for (const Into what : {Into::wall, Into::pole}) {
            const auto dent = [&](double rate) { return crash_stiff(what, 20, rate, m, plasticity).dent; };
            const double settled = dent(1920);
            EXPECT_GT(settled, 0.15);
            EXPECT_NEAR(dent(480), settled, 0.08 * settled) << name_of(plasticity);
            EXPECT_NEAR(dent(240), settled, 0.12 * settled) << name_of(plasticity);
            EXPECT_NEAR(dent(240), settled, 0.5 * 15 / 240) << name_of(plasticity);
        }
    }
}

// The wall pushes its nodes and never pulls them, so nothing turns a body that hits it straight. The grid's diagonals
// leave a little.
TEST(Carrier, AStiffBodyThatHitsAWallStraightDoesNotSpin) {
    EXPECT_LT(length(crash_stiff(Into::wall, 20, 60).angular_velocity), 0.3);
    EXPECT_LT(length(crash_stiff(Into::wall, 20, 240).angular_velocity), 0.3);
}

// Nothing but the nodes and a carrier of the given mass: the heavier, the less it gives way.
TEST(Carrier, AHeavyCarrierGivesWayLess) {
    double last = 1e30;
    for (const double times : {1.0, 3.0, 100.0}) {
        Rider rider(bumper(elastic_material(1e7)));
        const Hit hit{{-0.9, 0, 0}, {100, 0, 0}};
        double speed = 0;
        InstanceInput input = in_space();
        input.carrier_mass = times * rider.mass;
        rider.mass *= times;
        input.hits = {&hit, 1};
        for (int i = 0; i < 200; ++i) {
            rider.step(input);
            input.hits = {};
            speed = rider.motion.velocity.x;
        }
        EXPECT_NEAR(speed, 100 / rider.mass, 0.05 * 100 / rider.mass) << times;
        EXPECT_LT(speed, last);
        last = speed;
    }
}

// A blow on the free end: at first only the bumper moves, in the end everything does, with the blow's momentum.
TEST(Carrier, ABlowEndsAsTheMomentumOfTheWhole) {
    Material m = elastic_material(1e6);
    m.beta_s = 0.02;
    Rider rider(bumper(m), true);
    const Vec3 blow{0, 0, 40};
    const Vec3 at{-0.9, 0.3, 0.1};
    const Hit hit{at, blow};
    InstanceInput first = in_space();
    first.hits = {&hit, 1};
    rider.step(first);
    EXPECT_LT(length(rider.momentum() - blow), 1e-4 * length(blow));
    for (int i = 0; i < 200; ++i) {
        rider.step(in_space());
        EXPECT_LT(length(rider.momentum() - blow), 1e-4 * length(blow)) << i;
    }
    EXPECT_LT(length(rider.motion.velocity - blow / rider.mass), 1e-3 * length(blow / rider.mass));
    const Vec3 spin = cross(at, blow);
    EXPECT_LT(length(rider.spin() - spin), 1e-4 * length(spin));
}

// They turn with the carrier, and the torque it feels depends on that more than on its own inertia.
TEST(Carrier, NodesFlungFarOutKeepMomentumAndMakeNoEnergy) {
    Rider rider(bumper(elastic_material(1e3)), true);
    const auto is_flung = [](Vec3f p) { return p.x < -0.8f && p.y < 0; };
    rider.body.set_positions([&](Vec3f p) { return is_flung(p) ? p * 20.0f : p; });
    rider.body.set_velocities([&](Vec3f p) { return is_flung(p) ? Vec3f{-30, 60, -20} : Vec3f{}; });
    const Vec3 momentum = rider.momentum();
    const Vec3 spin = rider.spin();
    double start = 0;  // known once the first step has found the rotations
    for (int i = 0; i < 60; ++i) {
        rider.step(in_space());
        EXPECT_LT(length(rider.momentum() - momentum), 1e-4 * length(momentum)) << i;
        EXPECT_LT(length(rider.spin() - spin), 0.05 * length(spin)) << i;
        if (i == 0) start = rider.energy();
        EXPECT_LT(rider.energy(), 1.1 * start) << i;
    }
}

// Braking throws the free part forward; without inertia it does not.
TEST(Carrier, InertiaIsOptional) {
    for (const bool has_inertia : {false, true}) {
        Body body(bumper(elastic_material(1e6)));
        std::vector<Constraint> room(body.node_count());
        InstanceInput input = in_space();
        input.is_carrier_free = false;
        input.has_inertia = has_inertia;
        input.carrier.acceleration = {50, 0, 0};
        input.room = room;
        for (int i = 0; i < 30; ++i) step_instance(body.model, body.state, body.workspace, input, body.settings);
        const float shift = body.x(0).x - body.rest(0).x;
        EXPECT_EQ(shift < -1e-3f, has_inertia) << shift;
        EXPECT_EQ(shift == 0, !has_inertia) << shift;
    }
}

// On a turntable: at rest in the frame the pull outward is m w^2 r, so it stretches like under that load.
TEST(Carrier, ATurningFramePullsOutward) {
    Rider rider(bumper(elastic_material(1e7)));
    rider.motion.angular_velocity = {0, 0, 10};
    InstanceReport report;
    InstanceInput input = in_space();
    input.has_inertia = true;
    input.is_carrier_free = false;
    for (int i = 0; i < 400; ++i) report = rider.step(input);
    double centripetal = 0;
    for (std::size_t i = 0; i < rider.body.node_count(); ++i) {
        if (!rider.body.bundle.locked[i]) centripetal += rider.body.bundle.mass[i] * 100.0 * rider.body.x(i).x;
    }
    EXPECT_LT(rider.body.x(0).x, rider.body.rest(0).x - 1e-4f);
    double tip = 0;
    for (std::size_t i = 0; i < rider.body.node_count(); ++i) {
        tip = std::max(tip, static_cast<double>(length(velocity(rider.body.state, i))));
    }
    EXPECT_LT(tip, 0.05);  // settled: no spurious turning against the frame
    EXPECT_LT(centripetal, 0);
}

// However far the frame turns in a step.
TEST(Carrier, TheCoriolisForceTurnsAVelocityAndMakesItNoFaster) {
    Body body(grid_body({1, 1, 1}, {1, 1, 1}, elastic_material()));
    set_velocity(body.state, 0, {3, 4, 1});  // at the origin: nothing is thrown outward
    for (const float turn : {0.1f, 3.0f, 100.0f}) {
        StepInput input;
        input.frame_turn = {0, 0, turn};
        const Vec3f push = outside_force(body.model, body.state, input, 0) * (input.dt / body.bundle.mass[0]);
        const Vec3f v = velocity(body.state, 0);
        EXPECT_NEAR(length(v + push), length(v), 1e-5f * length(v));
        EXPECT_LT(dot(push, cross(Vec3f{0, 0, 1}, v)), 0);  // to the right of where it goes
    }
}

}
