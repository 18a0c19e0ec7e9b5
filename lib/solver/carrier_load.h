// SPDX-License-Identifier: MIT
// The load of a step on the rigid body that carries the nodes; see CarrierLoad for what it is.
#pragma once
#include "solver/carrier.h"
#include "solver/rigid_motion.h"
#include "solver/state.h"

namespace crumple::solver {

// What the nodes have of the whole's momentum beside the rigid body's, whose mass lies as theirs did at rest: in its
// frame they move, and with it they turn where they are now. In the frame, about its origin.
struct NodeShare {
    Six moving{};       // N s and N m s: of the nodes' velocities
    Matrix6 shifted{};  // of the mass, from rest
    Vec3 shift;         // kg m: sum of m (x - X)

    // With the frame turning at `turn`, rad/s.
    [[nodiscard]] Six at(Vec3 turn) const;
};

[[nodiscard]] NodeShare share_of(const Model& model, const State& state);

// Of one step.
struct LoadInput {
    double dt = 0;          // s
    Vec3 angular_velocity;  // rad/s, of the carrier, in the world
    bool is_carrier_free = true;
    double carrier_mass = 0;  // kg, nodes included (less than theirs counts as that)
    Six given{};              // N s and N m s, in the frame, about its origin: by obstacles, hits and forces
    NodeShare before;         // the step and its hits
};

// With S the nodes' share, q their shift and J what was given:
//     force dt = J - change of S,   torque dt = J - change of S - q x change of the origin's velocity.
// The state is that after the step.
[[nodiscard]] CarrierLoad load_of(const Model& model, const State& state, const Frame& frame, const LoadInput& input);

}
