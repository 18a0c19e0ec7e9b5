// SPDX-License-Identifier: GPL-3.0-or-later
// Generalized winding number of a triangle soup [Jacobson, Kavan, Sorkine-Hornung 2013]: 1 inside a closed outward
// surface, 0 outside, in between where the surface is open, one half on the surface itself.
//
// Triangles over each boundary loop close the surface. The winding number of the closed one is a whole number, counted
// exactly along a ray; the solid angle of those triangles, of which a closed surface has none, is what the holes let
// through.
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

    // A multiple of one half, exact, for a closed surface; within tolerance + 1e-9 for an open one. Costs a ray through
    // the triangles and a solid angle a boundary edge, of which a tolerance leaves out those far away.
    [[nodiscard]] double at(Vec3 p, double tolerance = 0) const;

    // Whether |at(p)| is above one half by more than rounding, so that a point on the surface is outside. Faster than
    // at(p): it asks for no more than the decision needs.
    [[nodiscard]] bool encloses(Vec3 p) const;

    // Whether p lies on a triangle, exactly.
    [[nodiscard]] bool is_on_surface(Vec3 p) const;

private:
    struct Surface;
    std::unique_ptr<Surface> surface_;
};

}
