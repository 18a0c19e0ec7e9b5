// SPDX-License-Identifier: GPL-3.0-or-later
// The point of a triangle soup nearest to a point.
#pragma once
#include <limits>
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"
#include "geometry/bvh.h"

namespace crumple {

class SurfaceDistance {
public:
    struct Closest {
        Index triangle = none;  // none for an empty soup
        Vec3 point;
        double distance = std::numeric_limits<double>::infinity();
    };

    // Copies what it needs. REQUIRES: indices within positions, positions finite.
    SurfaceDistance(std::span<const Vec3> positions, std::span<const Triangle> triangles);

    // Of equally near triangles the one of smallest number. `guess` is a triangle thought to be near (the answer for a
    // neighbouring point): it makes the answer faster, not different.
    [[nodiscard]] Closest closest(Vec3 p, Index guess = none) const;

    [[nodiscard]] bool empty() const { return corners_.empty(); }

private:
    [[nodiscard]] Vec3 closest_on(Index triangle, Vec3 p) const;

    std::vector<std::array<Vec3, 3>> corners_;  // F
    Bvh tree_;
};

}
