// SPDX-License-Identifier: MIT
// Keeps a solve that ran out of iterations from gaining energy. The exact step minimizes
//
//     |v - v_before|_M^2 / 2 + U(x + dt v)
//
// (U with R frozen), and to move rigidly strains nothing. Conjugate gradients start at v_before, where a stiff body
// that moves fast has much more than that, and may not have come down yet. So the last word is a line search toward the
// rigid response: toward standing still where nodes are fixed.
#pragma once
#include "solver/constraints.h"
#include "solver/solve.h"

namespace crumple::solver {

// Moves part t of the way toward the rigid response without its turning. Uses Workspace::direction.
void shorten_change(const Model& model, const State& state, Workspace& workspace, const ConstraintCounts& constraints,
                    Whole& whole, double t);

// Shortens Workspace::change where that lowers the sum above; all the way where the solve itself cannot be trusted.
// REQUIRES: solve() has run.
void restrain(const Model& model, const State& state, Workspace& workspace, const ConstraintCounts& constraints,
              const Solved& solved, Whole& whole, const Kernels& kernels, const Jobs& jobs);

}
