// SPDX-License-Identifier: GPL-3.0-or-later
// Exact signs. Any finite coordinates; a floating-point filter answers most calls, exact arithmetic the rest.
// grain: a power of two, 2^-200 at least, that divides every coordinate, or 0 when none is known. It only saves time:
// short multiples of it need no exact arithmetic.
#pragma once
#include "core/vec3.h"

namespace crumple {

// Sign of dot(b - a, cross(c - a, d - a)): +1 when (a, b, c, d) is a positive tet, 0 when the four are coplanar.
[[nodiscard]] int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d, double grain = 0);

// For a positive tet (a, b, c, d): +1 when e lies strictly inside its circumsphere, 0 on it, -1 outside.
[[nodiscard]] int in_sphere(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 e, double grain = 0);

// Whether the three lie on one line.
[[nodiscard]] bool are_collinear(Vec3 a, Vec3 b, Vec3 c);

}
