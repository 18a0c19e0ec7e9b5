// SPDX-License-Identifier: MIT
// Reads quantities off a state, in double: for tests, reports and whoever watches a run.
#pragma once
#include "solver/state.h"

namespace crumple::solver {

[[nodiscard]] Mat3 deformation_gradient(const Model& model, const State& state, std::size_t tet);  // elastic part
[[nodiscard]] Mat3 rotation(const State& state, std::size_t tet);  // as of the last step

[[nodiscard]] double kinetic_energy(const Model& model, const State& state);  // joules

// sum V (mu |eps|^2 + lambda / 2 tr(eps)^2) with the rotation nearest to F where the state is now, joules.
[[nodiscard]] double elastic_energy(const Model& model, const State& state);

[[nodiscard]] Vec3 linear_momentum(const Model& model, const State& state);
[[nodiscard]] Vec3 angular_momentum(const Model& model, const State& state);  // about the origin

}
