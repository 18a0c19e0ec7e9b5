// SPDX-License-Identifier: MIT
// What a step refuses before it touches anything: a bad number in one frame of a game must reach neither the state nor
// the rigid body that takes the load.
#pragma once
#include "solver/instance.h"

namespace crumple::solver {

// Squares of larger numbers, and sums of a few, may not be floats any more.
inline constexpr double largest_number = 1e18;

// True of numbers that are finite and no larger than that.
[[nodiscard]] bool is_usable(Vec3f v) noexcept;

// Orientation, place and velocities; the accelerations are looked at where they count.
[[nodiscard]] bool is_usable(const CarrierMotion& motion) noexcept;

// What a sleeping body looks at too: carrier, gravity, sleep settings, obstacles and hits.
[[nodiscard]] bool is_usable(const InstanceInput& input) noexcept;

// What a step needs besides constraints, of which bad ones are left out one by one.
[[nodiscard]] bool is_usable(const Model& model, const State& state, const StepInput& input,
                             const Settings& settings) noexcept;

}
