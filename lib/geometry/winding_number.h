// SPDX-License-Identifier: GPL-3.0-or-later
// Generalized winding number of a triangle soup [Jacobson, Kavan, Sorkine-Hornung 2013]: 1 inside a closed outward
// surface, 0 outside, in between where the surface is open, about one half on the surface itself. Accurate to 1e-9 at
// any distance: parts of the surface seen from outside their box are replaced by a fan over their boundary, not
// approximated.
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

    [[nodiscard]] double at(Vec3 p) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}
