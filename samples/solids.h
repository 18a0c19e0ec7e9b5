// SPDX-License-Identifier: MIT
// Closed solids that models are put together from, each added to a part and wound outward.
#pragma once
#include <span>

#include "samples/model.h"

namespace crumple::samples {

// A box of `cells` quads along each axis; rounding 0 is sharp, 1 an ellipsoid.
struct Box {
    Vec3 centre;
    Vec3 half;  // extents
    std::array<int, 3> cells = {1, 1, 1};
    double rounding = 0;
};
void add_box(Part& part, const Box& box, Color color);

// A solid of revolution around the x axis through `centre`. The profile holds (x, radius) pairs as Vec3{x, radius, 0}
// from low x to high x; its two ends are closed by discs unless their radius is 0. Staggered rings give triangles of
// equal sides instead of halves of rectangles.
void add_revolved(Part& part, Vec3 centre, std::span<const Vec3> profile, int segments, Color color,
                  bool staggers = false);

// A ring of round cross-section around `axis` (0: x, 1: y, 2: z).
struct Torus {
    Vec3 centre;
    int axis = 0;
    double radius = 1;
    double thickness = 0.1;  // radius of the cross-section
    int segments = 32;
    int sides = 12;
};
void add_torus(Part& part, const Torus& torus, Color color);

// A round pipe along a polyline of at least two points, closed at both ends.
void add_pipe(Part& part, std::span<const Vec3> path, double radius, int sides, Color color);

}
