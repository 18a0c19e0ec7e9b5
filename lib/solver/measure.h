// SPDX-License-Identifier: MIT
// Reads quantities off a state, in double: for tests, reports and whoever watches a run.
#pragma once
#include "solver/rigid_motion.h"
#include "solver/state.h"

namespace crumple::solver {

[[nodiscard]] Mat3 deformation_gradient(const Model& model, const State& state, std::size_t tet);  // elastic part
[[nodiscard]] Mat3 rotation(const State& state, std::size_t tet);  // as of the last step

// The norm of what was kept of strain: eps_p, or F_p - I where plasticity is multiplicative.
[[nodiscard]] float plastic_strain(const Model& model, const State& state, std::size_t tet);

[[nodiscard]] double kinetic_energy(const Model& model, const State& state);  // joules

// sum V (mu |eps|^2 + lambda / 2 tr(eps)^2), joules. With the rotation nearest to F it is that of F alone; with
// the rotations of `state` it is what the solver sees, where a treatment may hold on to another for an inverted tet.
enum class EnergyRotation { nearest, of_state };
[[nodiscard]] double elastic_energy(const Model& model, const State& state,
                                    EnergyRotation which = EnergyRotation::nearest);

[[nodiscard]] Vec3 linear_momentum(const Model& model, const State& state);
[[nodiscard]] Vec3 angular_momentum(const Model& model, const State& state);  // about the origin

// Momentum and angular momentum of the nodes, in the frame, about its origin.
[[nodiscard]] Six momentum_of(const Model& model, const State& state);

}
