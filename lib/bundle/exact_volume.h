// SPDX-License-Identifier: MIT
// The volume of a tet over float positions, good to about 1e-7 of itself however flat the tet is, with an exact sign.
#pragma once
#include <array>

#include "core/vec3.h"

namespace crumple {

// dot(b - a, cross(c - a, d - a)): six times the volume, positive for a positive tet, 0 only when the four are
// coplanar. REQUIRES: finite coordinates.
[[nodiscard]] double six_volumes(Vec3f a, Vec3f b, Vec3f c, Vec3f d);

// Dm^-1 row-major for Dm = [b-a c-a d-a] as columns: rows are the gradients of the barycentric weights of b, c and d.
// Not finite where the tet is flat.
[[nodiscard]] std::array<double, 9> inverse_rest_matrix(Vec3f a, Vec3f b, Vec3f c, Vec3f d);

}
