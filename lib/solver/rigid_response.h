// SPDX-License-Identifier: MIT
// What a free body would do in this step if it could not deform: the motion its momentum makes, changed as little as
// constraints and contacts ask for. It is where a solve may always end, for no tet is strained there and, where
// obstacles stand still, kinetic energy can only go down; how far the solve got decides how much better it does.
#pragma once
#include "solver/rigid_locks.h"

namespace crumple::solver {

struct RigidResponse {
    bool is_given = false;
    Six motion{};  // after the step
    Six jump{};    // what of it comes from constraints and contacts
    Six slide{};   // a translation near it that meets the constraints too
    Six haven{};   // the motion, or the slide where it turns so far in the step that straight ways strain the body
};

// REQUIRES: no node is fixed; partials are listed. `momentum` is that before velocities met their
// constraints and what forces add in this step.
// [Gauss's principle of least constraint; projected Gauss-Seidel over the contacts: Moreau 1999, "Numerical aspects of
// the sweeping process", section 10.]
[[nodiscard]] RigidResponse respond_rigidly(const Model& model, const State& state, const StepInput& input,
                                            Workspace& workspace, std::span<const Partial> partials,
                                            const RigidLocks& locks, const Six& momentum);

// The velocity the response gives a loose node: where its contact is nearer than that, it stops there.
[[nodiscard]] Vec3 response_velocity(const Six& motion, const Partial& partial, Vec3 x, Vec3 v);

}
