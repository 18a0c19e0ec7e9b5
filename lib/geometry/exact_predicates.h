// SPDX-License-Identifier: GPL-3.0-or-later
// The exact rungs under the floating-point filters of predicates.h. Callers that own a filter (delaunay) come here
// directly. Any finite coordinates.
#pragma once
#include "core/vec3.h"

namespace crumple::exact {

// Same answers as the functions of predicates.h, without a filter in front.
[[nodiscard]] int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d);
[[nodiscard]] int in_sphere(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 e);
[[nodiscard]] bool are_collinear(Vec3 a, Vec3 b, Vec3 c);

}
