// SPDX-License-Identifier: MIT
// A state from outside, a saved game or the network, before it is stepped.
#pragma once
#include "solver/state.h"

namespace crumple::solver {

// Null for every state that a step left behind; else why one could read outside its arrays or never be finite again.
// REQUIRES: the state was placed for this model in memory of state_bytes, whatever is in it.
[[nodiscard]] const char* first_problem(const Model& model, const State& state) noexcept;

}
