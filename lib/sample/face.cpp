// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/face.h"

#include <cmath>

namespace crumple::sample {

FaceBall::FaceBall(Vec3 a, Vec3 b, Vec3 c) : centre((a + b + c) / 3.0) {
    for (const Vec3 corner : {a, b, c}) {
        // Larger by far more than rounding can take away.
        radius = std::max(radius, length(corner - centre) * 1.000001 + length(centre) * 1e-12);
    }
}

Face::Face(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 corners[] = {a, b, c};
    for (std::size_t i = 0; i < 3; ++i) {
        Side& side = sides[i];
        side.start = corners[i];
        side.along = corners[(i + 1) % 3] - corners[i];
        const double length_2 = dot(side.along, side.along);
        side.inverse_length_2 = length_2 > 0 ? 1 / length_2 : 0;
    }
    const Vec3 area_normal = cross(b - a, c - a);
    const double area_2 = dot(area_normal, area_normal);
    has_area = area_2 > 0;
    if (!has_area) return;
    to_b = cross(c - a, area_normal) / area_2;
    to_c = cross(area_normal, b - a) / area_2;
    normal = area_normal / std::sqrt(area_2);
}

}
