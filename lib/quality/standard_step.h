// SPDX-License-Identifier: GPL-3.0-or-later
// One implicit step as every mesh is asked to take it, so that meshes of one shape can be compared by its iterations.
#pragma once
#include <cstdint>
#include <span>

#include "quality/elastic_system.h"

namespace crumple::quality {

inline constexpr std::uint32_t most_step_iterations = 5000;

// Iterations of conjugate gradients, from zero, on (M + step^2 K) x = b with scalar Jacobi as preconditioner until the
// residual is 1e-4 of what it was; most_step_iterations where it is not by then. `step` is a time multiplied by the
// speed of sound, metres.
[[nodiscard]] std::uint32_t count_iterations(const ElasticSystem& system, double step, std::span<const Vec3> b);

}
