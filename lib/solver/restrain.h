// SPDX-License-Identifier: MIT
// Keeps a solve that ran out of iterations from gaining energy. The exact step minimizes
//
//     |v - v_before|_M^2 / 2 + U(x + dt v)
//
// (U with R frozen), and standing still gives it today's energy. Conjugate gradients start at v_before, where a stiff
// body that moves fast has much more than that, and may not have come down yet. So the last word is a line search
// toward standing still: toward the mean velocity for a free body, so that its momentum stays.
#pragma once
#include "solver/constraints.h"
#include "solver/solve.h"

namespace crumple::solver {

// Takes away part t of the velocities toward standing still. Uses Workspace::direction.
void shorten_change(const Model& model, const State& state, Workspace& workspace, const ConstraintCounts& constraints,
                    RigidLocks& rigid, double t);

// Shortens Workspace::change where that lowers the sum above; all the way where the solve itself cannot be trusted.
// REQUIRES: solve() has run.
void restrain(const Model& model, const State& state, Workspace& workspace, const ConstraintCounts& constraints,
              const Solved& solved, RigidLocks& rigid, const Kernels& kernels, const Jobs& jobs);

}
