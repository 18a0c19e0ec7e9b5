// SPDX-License-Identifier: GPL-3.0-or-later
// Two neighbouring faces of the surface as a four-sided patch, measured in floating point.
#pragma once
#include <array>

#include "core/vec3.h"

namespace crumple::finish {

// The faces (a, p, b) and (a, b, q), counter-clockwise from outside.
struct SurfacePatch {
    Vec3 a, p, b, q;

    // Between the two diagonals: how far the surface moves when one takes the other's place.
    [[nodiscard]] double gap() const;
    [[nodiscard]] double mean_side() const;

    // Whether the folds along both diagonals are within an angle of this squared sine.
    [[nodiscard]] bool is_flat(double sine_2) const;

    // Whether a triangle that the sweep from one diagonal to the other could run into keeps clear of it: lies behind,
    // beside or before the patch by more than the gap.
    [[nodiscard]] bool is_clear_of(const std::array<Vec3, 3>& triangle) const;
};

// Both normals point to the same side and enclose an angle of at most this squared sine.
[[nodiscard]] bool is_fold_within(Vec3 n, Vec3 m, double sine_2);

// Distance between the lines through (a, b) and (p, q), 0 where they are parallel.
[[nodiscard]] double gap_between(Vec3 a, Vec3 b, Vec3 p, Vec3 q);

}
