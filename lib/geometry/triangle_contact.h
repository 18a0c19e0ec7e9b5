// SPDX-License-Identifier: GPL-3.0-or-later
// Do two triangles meet anywhere they should not? Exact: built on orient3d alone.
#pragma once
#include <array>

#include "core/vec3.h"

namespace crumple {

using Corners = std::array<Vec3, 3>;

// True when the closed triangles share a point. Corners of equal coordinates are one and the same: triangles that share
// a corner or an edge meet only if they also meet elsewhere, and two triangles of the same three corners do not count.
// A triangle without area never meets anything.
[[nodiscard]] bool triangles_meet(const Corners& a, const Corners& b);

// True when p lies on the closed triangle; nothing lies on one without area.
[[nodiscard]] bool is_on_triangle(const Corners& triangle, Vec3 p);

// Where to look for the contact of two triangles that meet: a point near both, in floating point.
[[nodiscard]] Vec3 contact_place(const Corners& a, const Corners& b);

}
