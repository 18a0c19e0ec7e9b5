// SPDX-License-Identifier: MIT
// Which contacts hold while a step is solved: one that would pull lets go, one that would be passed holds
// [the active set of a bound constrained quadratic program; Dostal 2009, "Optimal quadratic programming algorithms"].
#pragma once
#include "solver/rigid_modes.h"

namespace crumple::solver {

// Of contacts that all hold, lets those go that nothing presses on where the solve starts; their preconditioners
// follow. The part of the residual that is held goes.
void hold_touching(const Model& model, const State& state, Workspace& workspace, std::span<Partial> partials);

enum class Recheck {
    all,
    passed_only,  // what is held keeps being held
};

// Nodes that went past their contact stop at it, contacts that pull let go; `change`, residual and preconditioner
// and modes, where there are any, follow. Says whether anything changed.
bool recheck_contacts(const Model& model, const State& state, Workspace& workspace, std::span<Partial> partials,
                      RigidLocks& locks, RigidModes* modes, Recheck what);

}
