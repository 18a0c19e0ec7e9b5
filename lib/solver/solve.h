// SPDX-License-Identifier: MIT
// Preconditioned conjugate gradients with the inverse diagonal blocks as preconditioner, on what constraints and
// contacts leave free, the rigid motions of a free body solved for exactly.
#pragma once
#include "solver/rigid_locks.h"
#include "solver/rigid_modes.h"
#include "solver/rigid_response.h"
#include "solver/step.h"

namespace crumple::solver {

// What moves as a whole.
struct Whole {
    RigidLocks locks;
    RigidResponse response;  // where no node is fixed
};

struct Solved {
    std::uint32_t iterations = 0;
    float residual = 0;
    bool is_too_stiff = false;    // p . A p <= 0: the solve stopped there
    bool has_overflowed = false;  // the load is not finite: nothing was solved
};

[[nodiscard]] SolveJob solve_job(const Model& model, Workspace& workspace);

// Solves A change = load, together with the motion of the locks. REQUIRES: blocks, inverse, load and the constraints of
// the workspace are filled.
Solved solve(const Model& model, Workspace& workspace, std::size_t partial_count, const Settings& settings,
             const State& state, Whole& whole, const Kernels& kernels, const Jobs& jobs);

}
