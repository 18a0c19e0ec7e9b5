// SPDX-License-Identifier: MIT
// The end of a step: velocities and positions take the change the solve found, or less of it.
//
// The solve keeps the rotations of the tets frozen. A tet under tension that turns far in one step looks relaxed to the
// solve and is not: its energy would appear from nowhere. So the energy at the end is measured with the rotations found
// there, and where it is above what was put in, the change is cut short toward standing still, where nothing is gained.
// Contacts that ask for more than that tear at a body that stands: as the last way out they give way.
//
// The ledger is in the header of the state: `energy` is what the body held at the end of the last step, `budget` what
// was put in. What changed between steps was the caller's doing and counts as put in.
#pragma once
#include "solver/pushes.h"
#include "solver/restrain.h"

namespace crumple::solver {

// A body may hold this many times its budget: a body that spins fast swells in a step with frozen rotations, and must
// not be slowed for it.
inline constexpr double budget_slack = 1.5;

struct Advanced {
    double energy = 0;  // kinetic and elastic, J
    Vec3 impulse;       // as StepReport has them
    Vec3 angular_impulse;
    bool is_cut = false;
    bool has_overflowed = false;
};

// `elements` is the job of this step. Fills the reactions when asked.
// REQUIRES: restrain() has run.
Advanced advance(const Model& model, State& state, Workspace& workspace, const StepInput& input,
                 const ConstraintCounts& constraints, const ElementJob& elements, const Ledger& ledger, Whole& whole,
                 const Kernels& kernels, const Jobs& jobs);

}
