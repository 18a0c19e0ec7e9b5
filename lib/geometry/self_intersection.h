// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles of a soup meet where they should not. Exact, so touching counts and a gap of one ulp does not.
#pragma once
#include <span>
#include <vector>

#include "core/context.h"
#include "core/index.h"
#include "core/vec3.h"

namespace crumple {

struct MeetingTriangles {
    Index first = 0;  // first < second
    Index second = 0;
    Vec3 place;  // near the contact, in floating point
};

// All pairs in ascending order; a shared corner or edge (equal coordinates) is no meeting, and neither is a duplicate.
// Stops at `limit` pairs a triangle, so that a soup of copies stays linear. REQUIRES: indices within positions.
[[nodiscard]] std::vector<MeetingTriangles> self_intersections(std::span<const Vec3> positions,
                                                               std::span<const Triangle> triangles,
                                                               const Context& context = {}, std::size_t limit = 64);

}
