// SPDX-License-Identifier: MIT
// The few curves the generators draw with. Plain arithmetic and square roots only: the same bits on every platform.
#pragma once
#include <span>
#include <vector>

#include "core/vec3.h"

namespace crumple::samples {

// A point of the unit circle.
struct Turn {
    double cosine;
    double sine;
};
[[nodiscard]] Turn turn(double fraction);  // of a full turn, in [0, 1]

// A smooth function through keys of ascending z, flat beyond both ends, that never overshoots a key
// [Fritsch and Butland 1984, harmonic mean of the slopes].
struct Key {
    double z;
    double value;
};
[[nodiscard]] double interpolate(std::span<const Key> keys, double z);

// Point at u in [0, controls.size() - 1] of the quadratic B-spline with those control points, clamped at both ends:
// near control point k at u = k, and at the first and last exactly. REQUIRES: at least three control points.
[[nodiscard]] Vec3 spline(std::span<const Vec3> controls, double u);

}
