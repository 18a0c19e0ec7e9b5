// SPDX-License-Identifier: GPL-3.0-or-later
// How stiff one linear tet is, which bounds the time step of an explicit solver and the work of an implicit one.
#pragma once
#include "core/vec3.h"

namespace crumple::quality {

inline constexpr double poisson = 0.3;
inline constexpr double lame_mu = 1 / (2 * (1 + poisson));
inline constexpr double lame_lambda = poisson / ((1 + poisson) * (1 - 2 * poisson));

// Of isotropic linear elasticity with Young's modulus 1 and Poisson's ratio 0.3.
struct ElementStiffness {
    double largest = 0;  // eigenvalue of the 12 x 12 stiffness matrix, metres
    // Largest stable explicit step times the speed of sound sqrt(young / density), metres:
    // 2 / sqrt(largest / (density volume / 4)). The step of a mesh is at least that of its worst element
    // [Irons 1970, "Applications of a theorem on eigenvalues to finite element problems"].
    double step = 0;
};

// Both 0 for a tet that is flat or turned inside out.
[[nodiscard]] ElementStiffness measure_stiffness(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

// The step of a regular tet of that volume: what a step is compared with.
[[nodiscard]] double regular_step(double volume);

}
