// SPDX-License-Identifier: GPL-3.0-or-later
// A triangle prepared for being asked many times how far it is. Only measures; about three times as fast as
// closest_point_on_triangle, and a ball around it rules out most triangles before that.
#pragma once
#include <algorithm>
#include <array>

#include "core/vec3.h"

namespace crumple::sample {

// Holds a triangle. Kept apart from the rest, so that many fit into the cache.
struct FaceBall {
    FaceBall(Vec3 a, Vec3 b, Vec3 c);

    [[nodiscard]] double centre_distance_2(Vec3 p) const { return dot(centre - p, centre - p); }

    // Whether the triangle may be as near as `distance` to a place of that squared distance from the centre.
    [[nodiscard]] bool may_reach(double distance_2_of_centre, double distance) const {
        const double reach = distance + radius;
        return distance_2_of_centre <= reach * reach;
    }

    Vec3 centre;
    double radius = 0;
};

struct Face {
    Face(Vec3 a, Vec3 b, Vec3 c);

    // Squared metres.
    [[nodiscard]] double distance_2(Vec3 p) const;

    struct Side {
        Vec3 start;
        Vec3 along;
        double inverse_length_2 = 0;  // 0 for a side of no length
        [[nodiscard]] double distance_2(Vec3 p) const;
    };

    // With u = to_b.(p - a) and v = to_c.(p - a), the foot of p on the plane is a + u (b - a) + v (c - a).
    Vec3 to_b;
    Vec3 to_c;
    Vec3 normal;
    bool has_area = false;
    std::array<Side, 3> sides;  // the first starts at a
};

inline double Face::Side::distance_2(Vec3 p) const {
    const Vec3 from_start = p - start;
    const double share = std::clamp(dot(from_start, along) * inverse_length_2, 0.0, 1.0);
    const Vec3 to = from_start - along * share;
    return dot(to, to);
}

inline double Face::distance_2(Vec3 p) const {
    const Vec3 from_a = p - sides[0].start;
    const double u = dot(from_a, to_b);
    const double v = dot(from_a, to_c);
    if (has_area && u >= 0 && v >= 0 && u + v <= 1) {
        const double height = dot(from_a, normal);
        return height * height;
    }
    return std::min({sides[0].distance_2(p), sides[1].distance_2(p), sides[2].distance_2(p)});
}

}
