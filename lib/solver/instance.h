// SPDX-License-Identifier: MIT
// One deforming thing in a game: a step with its carrier, obstacles, hits and handles, asleep while nothing happens.
#pragma once
#include "solver/contact.h"
#include "solver/spline.h"

namespace crumple::solver {

struct SleepSettings {
    float speed = 0.02f;      // m/s: slower than this everywhere...
    float after_s = 0.5f;     // ...for so long is asleep
    float wake_speed = 0.1f;  // m/s of an obstacle that reaches the body
    float wake_pull = 2;      // m/s^2: change of gravity and inertia
};

// Obstacles, hits, gravity and wind in the world, all else in the carrier's frame.
struct InstanceInput {
    float dt = 1.0f / 60;
    CarrierMotion carrier;
    // A free carrier gives way in the step that pushes it: give its mass, nodes included, or 0 where the nodes are all
    // of it. Before the next step give it the load's change of velocity, then move it with the new velocity. Else it
    // goes its way, as if without end of mass.
    bool is_carrier_free = true;
    double carrier_mass = 0;
    // The carrier's acceleration and turning throw the nodes about: of a free one, what others than this body do to it.
    // A carrier that is moved by the load only a step later stays stable while the free nodes weigh less than half of
    // it.
    bool has_inertia = false;
    Vec3 gravity{0, -9.81, 0};
    std::span<const Obstacle> obstacles;
    std::span<const Hit> hits;
    const Wind* wind = nullptr;
    std::span<const Vec3f> forces;            // N or empty
    std::span<const Constraint> constraints;  // beside locks; a node named here feels no obstacle
    std::span<Constraint> room;               // for `constraints` and the contacts: as many as may happen at once
    std::span<Vec3f> reactions;               // N or empty, see StepInput; untouched by a sleeper
    SleepSettings sleep;
    bool may_sleep = true;
};

struct InstanceReport {
    StepReport step;
    CarrierLoad load;  // always finite; 0 where the input was refused
    std::size_t contacts = 0;
    bool is_room_too_small = false;  // some contacts were left out
    bool is_asleep = false;          // nothing was done
};

// An input that holds a number which is none, or is 0 or negative where that makes no sense (check_input.h; crumple.h
// lists it), is refused: step_bad_input, the state unchanged. Forces and constraints of the caller wake by wake() only:
// whoever gives them knows when.
InstanceReport step_instance(const Model& model, State& state, Workspace& workspace, const InstanceInput& input,
                             const Settings& settings = {}, const Jobs& jobs = {}) noexcept;

void wake(State& state) noexcept;
[[nodiscard]] inline bool is_asleep(const State& state) { return state.header->is_asleep != 0; }

}
