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

// One ring of a solid of revolution.
struct Hoop {
    double x;       // along the axis
    double radius;  // 0 at the first and the last: the tips
    int count = 0;  // vertices
    double offset =
        0;  // turned by this part of an edge; half an edge for every other hoop gives triangles of equal sides
};

// A solid of revolution around the x axis through `centre`, from low x to high x.
void add_revolved(Part& part, Vec3 centre, std::span<const Hoop> hoops, Color color);

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
