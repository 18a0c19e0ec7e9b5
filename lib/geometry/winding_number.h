// SPDX-License-Identifier: GPL-3.0-or-later
// Generalized winding number of a triangle soup [Jacobson, Kavan, Sorkine-Hornung 2013]: 1 inside a closed outward
// surface, 0 outside, in between where the surface is open. Evaluated over a tree with the far-field expansion of
// [Barill, Dickson, Schmidt, Levin, Jacobson 2018] where it cannot change a decision, exactly near the surface.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple {

class WindingNumber {
public:
    // Copies what it needs; F = triangles.size(), any order of triangles gives the same answer to 1e-9.
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
