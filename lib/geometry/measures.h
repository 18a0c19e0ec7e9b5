// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes and places of triangles and tets in floating point. They only measure: decisions belong to predicates.h.
#pragma once
#include <array>
#include <cmath>

#include "core/vec3.h"

namespace crumple {

struct Box {
    Vec3 low{1e300, 1e300, 1e300};
    Vec3 high{-1e300, -1e300, -1e300};

    void add(Vec3 p) {
        for (int axis = 0; axis < 3; ++axis) {
            if (p[axis] < low[axis]) low[axis] = p[axis];
            if (p[axis] > high[axis]) high[axis] = p[axis];
        }
    }
    [[nodiscard]] bool holds(Vec3 p) const {
        return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z && p.z <= high.z;
    }
    [[nodiscard]] double diagonal() const { return low.x > high.x ? 0 : length(high - low); }
};

template <class Positions>
Box bounding_box(const Positions& positions) {
    Box box;
    for (const Vec3& p : positions) box.add(p);
    return box;
}

// Positive when orient3d(a, b, c, d) is.
inline double signed_volume(Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return dot(b - a, cross(c - a, d - a)) / 6; }

// Twice the area, along the normal of the counter-clockwise side.
inline Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) { return cross(b - a, c - a); }

// Weights of a, b, c, d at p; they sum to 1 and are negative outside. Undefined for a flat tet.
std::array<double, 4> barycentric(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 p);

// Centre of the sphere through the corners. Undefined for a flat tet.
Vec3 circumcentre(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

// The point of the triangle nearest to p [Ericson 2005, section 5.1.5].
struct ClosestOnTriangle {
    Vec3 point;
    unsigned corners =
        0;  // bits 0..2: the corners whose corner, edge or face the point lies in: a = 1, ab = 3, abc = 7
};
ClosestOnTriangle closest_on_triangle(Vec3 a, Vec3 b, Vec3 c, Vec3 p);
inline Vec3 closest_point_on_triangle(Vec3 a, Vec3 b, Vec3 c, Vec3 p) { return closest_on_triangle(a, b, c, p).point; }

}
