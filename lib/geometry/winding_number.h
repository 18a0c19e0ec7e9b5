// SPDX-License-Identifier: GPL-3.0-or-later
// Generalized winding number of a triangle soup [Jacobson, Kavan, Sorkine-Hornung 2013]: 1 inside a closed outward
// surface, 0 outside, in between where the surface is open, one half on the surface itself.
//
// A fan over each boundary loop closes the surface. The winding number of the closed one is a whole number, counted
// exactly along a ray; the solid angle of the fans, of which a closed surface has none, is what the holes let through.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple {

class WindingNumber {
public:
    // Copies what it needs. The order of vertices and triangles and unwelded copies of a place do not change one bit of
    // an answer. REQUIRES: indices within positions, positions finite.
    WindingNumber(std::span<const Vec3> positions, std::span<const Triangle> triangles);
    ~WindingNumber();
    WindingNumber(WindingNumber&&) noexcept;
    WindingNumber& operator=(WindingNumber&&) noexcept;

    // A multiple of one half, exact, for a closed surface; within 1e-9 for an open one. Costs a ray through the
    // triangles and one solid angle a boundary edge.
    [[nodiscard]] double at(Vec3 p) const;

private:
    struct Surface;
    std::unique_ptr<Surface> surface_;
};

}
