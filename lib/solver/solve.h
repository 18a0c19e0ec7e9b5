// SPDX-License-Identifier: MIT
// Preconditioned conjugate gradients with the inverse diagonal blocks as preconditioner, on what constraints leave
// free.
#pragma once
#include "solver/rigid_locks.h"
#include "solver/step.h"

namespace crumple::solver {

struct Solved {
    std::uint32_t iterations = 0;
    float residual = 0;
    bool is_too_stiff = false;    // p . A p <= 0: the solve stopped there
    bool has_overflowed = false;  // the load is not finite: nothing was solved
};

[[nodiscard]] SolveJob solve_job(const Model& model, Workspace& workspace);

// What conjugate gradients would take many iterations to find: that a body that is hit moves as a whole.
struct FirstGuess {
    bool is_given = false;
    Six motion{};  // of which the solve takes the best multiple
};

// Solves A change = load, together with the motion of the locks where `rigid` is active. REQUIRES: blocks, inverse,
// load and the constraints of the workspace are filled.
Solved solve(const Model& model, Workspace& workspace, std::size_t partial_count, const Settings& settings,
             const State& state, const FirstGuess& guess, RigidLocks& rigid, const Kernels& kernels, const Jobs& jobs);

}
