// SPDX-License-Identifier: MIT
// Locked nodes as one rigid body that is solved for together with the rest. A carrier that answers a step late makes a
// stiff body hit a wall as if it had no end: in one step the contact takes many times the momentum there is. Here the
// solve has six unknowns more, the change of the carrier's velocity and turning during the step, and what the locked
// nodes do is T = [I, -[x]] of them: conjugate gradients on T^T A T, symmetric and positive definite as before.
#pragma once
#include "solver/rigid_motion.h"
#include "solver/step.h"

namespace crumple::solver {

struct RigidLocks {
    bool is_active = false;
    Matrix6 inverse{};   // of T^T A T, the carrier's own mass in it
    Matrix6 own_mass{};  // what the carrier weighs beside the nodes
    Six fall{};          // what gravity gives it in a step
    Six residual{}, precise{}, direction{}, product{}, change{};
};

// REQUIRES: the matrix is assembled. `carrier_mass` is the whole's; less than the nodes' counts as theirs.
// `fall` is dt times gravity, which the carrier's own mass feels too.
[[nodiscard]] RigidLocks make_rigid_locks(const Model& model, const Workspace& workspace, double carrier_mass,
                                          Vec3f fall);

// Whether a node moves with the carrier: it is locked, and no constraint of this step says otherwise.
[[nodiscard]] inline bool is_carried(const Model& model, const Workspace& w, std::size_t node) {
    return model.bundle.locked[node] && w.constraint[node] == 0;
}

// T^T of the carried rows of `rows`, which are then 0.
[[nodiscard]] Six take_carried(const Model& model, const Workspace& workspace, std::span<float> rows);

// The parts of the solve that touch locked rows; each does nothing when not active.
void start_rigid(RigidLocks& rigid, const Model& model, Workspace& workspace);  // r_R += T^T load; their rows of r: 0
[[nodiscard]] double precondition_rigid(RigidLocks& rigid);                     // z_R; r_R . z_R
void spread_rigid(const RigidLocks& rigid, const Model& model, Workspace& workspace);  // rows of p = T p_R
// q_R = T^T (rows of q) + own mass p_R; their rows of q: 0. Returns p_R . (own mass p_R).
[[nodiscard]] double gather_rigid(RigidLocks& rigid, const Model& model, Workspace& workspace);
void descend_rigid(RigidLocks& rigid, double a);
void turn_rigid(RigidLocks& rigid, double b);

}
