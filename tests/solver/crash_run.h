// SPDX-License-Identifier: MIT
// A crash made up by a seed: a wild body on a carrier, obstacles, blows, wind, handles, and the sum of what all of them
// do to it.
#pragma once
#include <array>

#include "solver/body.h"
#include "solver/instance.h"

namespace crumple::solver::test {

// The carrier as the simplest rigid body: the mass of the nodes at rest around the origin, times a factor.
struct RigidBody {
    CarrierMotion motion;
    double mass = 0;
    Mat3d inertia;  // about the origin, in the frame

    // Takes a force and a torque for dt, then moves on; angular momentum is kept in the world.
    void push(Vec3 force, Vec3 torque, double dt);
    void move(double dt);

private:
    [[nodiscard]] Mat3d world_inertia() const;
    [[nodiscard]] Vec3 turning(Vec3 angular_momentum) const;
    Vec3 angular_momentum_;
};

// Energy is that of nodes and carrier, seen from the world, where the carrier is free; where it goes its own way, that
// of the nodes seen from the carrier. A driven carrier gets all of it: nodes anywhere, at up to 100 m/s, handles that
// tear at them. A free one weighs at least as much again as the nodes, is hit by less and has no handles: what follows
// the carrier and pushes it from outside is a rocket.
class CrashRun {
public:
    explicit CrashRun(std::uint64_t seed);

    void step();

    [[nodiscard]] bool is_finite() const;
    // Energy at the begin and the end of the last step is at most twice that of the start and the work of all that
    // pushed from outside. What took energy away again is not held against it.
    [[nodiscard]] bool is_bounded() const;
    // The most the carrier has turned in a step, rad.
    [[nodiscard]] double turned() const { return turned_; }

    Body body;
    InstanceReport report;
    bool is_free = false;

private:
    struct Handles {
        std::vector<Index> nodes;
        std::array<float, 4> times;
        std::array<Vec3f, 4> shifts, shift_slopes, turns, turn_slopes;
        std::array<float, 4> scratch;
    };
    struct Begin;
    CrashRun(std::uint64_t seed, Rng rng);
    void set_going();
    void put_obstacles();
    void take_hold();
    [[nodiscard]] InstanceInput next_input();
    void add_handles(std::vector<Constraint>& constraints) const;
    [[nodiscard]] Six given_by_hits(const InstanceInput& input);
    [[nodiscard]] std::vector<Vec3> known_impulses(const InstanceInput& input);
    [[nodiscard]] std::vector<Vec3> node_velocities() const;
    [[nodiscard]] double kinetic() const;
    [[nodiscard]] double work_within(const InstanceInput& input, std::size_t node, Vec3 place, Vec3 own_before) const;
    [[nodiscard]] double allowed() const { return start_ + work_; }
    void give(double work);
    [[nodiscard]] Begin look_ahead(const InstanceInput& input);
    void add_work(const InstanceInput& input, const Begin& begin);
    void move_free_carrier(const InstanceInput& input, const Six& hits);
    void move_driven_carrier(double dt);

    Rng rng_;
    std::uint64_t seed_;
    RigidBody carrier_;
    double extra_ = 0;  // mass of the carrier beside the nodes, in masses of the nodes
    InstanceInput input_;
    std::vector<Obstacle> obstacles_;
    std::vector<Hit> hits_;
    Wind wind_;
    std::vector<Vec3f> forces_, reactions_;
    std::vector<Constraint> constraints_, room_;
    std::vector<Handles> handles_;
    bool has_weight_ = false;  // the game lets the carrier fall
    int steps_ = 0;
    float time_ = 0;
    double start_ = 0, work_ = 0, energy_ = 0, energy_at_begin_ = 0, allowed_at_begin_ = 0;
    double noise_ = 0;  // what float rounding of positions holds
    double turned_ = 0;
};

}
