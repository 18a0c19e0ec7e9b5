// SPDX-License-Identifier: MIT
// Locked nodes as one rigid body that is solved for together with the rest. A carrier that answers a step late makes a
// stiff body hit a wall as if it had no end: in one step the contact takes many times the momentum there is. Here the
// solve has six unknowns more, the change of the carrier's velocity and turning during the step, and what the locked
// nodes do is T = [I, -[x]] of them: conjugate gradients on T^T A T, symmetric and positive definite as before.
#pragma once
#include <array>

#include "solver/step.h"

namespace crumple::solver {

using Six = std::array<double, 6>;  // velocity, angular velocity (or their duals) in the frame, about its origin

[[nodiscard]] inline double dot6(const Six& a, const Six& b) {
    double sum = 0;
    for (std::size_t i = 0; i < 6; ++i) sum += a[i] * b[i];
    return sum;
}

[[nodiscard]] inline Vec3 rigid_velocity(const Six& v, Vec3 x) {
    return Vec3{v[0], v[1], v[2]} + cross(Vec3{v[3], v[4], v[5]}, x);
}

struct RigidLocks {
    bool is_active = false;
    std::array<double, 36> inverse{};   // of T^T A T, the carrier's own mass in it
    std::array<double, 36> own_mass{};  // what the carrier weighs beside the nodes
    Six residual{}, precise{}, direction{}, product{}, change{};
};

// REQUIRES: the matrix is assembled. `carrier_mass` is the whole's; less than the nodes' counts as theirs.
// `fall` is dt times gravity, which the carrier's own mass feels too.
[[nodiscard]] RigidLocks make_rigid_locks(const Model& model, const Workspace& workspace, double carrier_mass,
                                          Vec3f fall);

// The rigid motion that fits best the change of velocity the step's constraints on loose nodes ask for, of its first
// guess. Before velocities meet their constraints. False where they ask for none.
[[nodiscard]] bool fit_jump(const Model& model, const State& state, const Workspace& workspace, const StepInput& input,
                            Six& jump);

// The parts of the solve that touch locked rows; each does nothing when not active.
void start_rigid(RigidLocks& rigid, const Model& model, Workspace& workspace);  // r_R += T^T load; their rows of r: 0
[[nodiscard]] double precondition_rigid(RigidLocks& rigid);                     // z_R; r_R . z_R
void spread_rigid(const RigidLocks& rigid, const Model& model, Workspace& workspace);  // rows of p = T p_R
// q_R = T^T (rows of q) + own mass p_R; their rows of q: 0. Returns p_R . (own mass p_R).
[[nodiscard]] double gather_rigid(RigidLocks& rigid, const Model& model, Workspace& workspace);
void descend_rigid(RigidLocks& rigid, double a);
void turn_rigid(RigidLocks& rigid, double b);

}
