// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/surface_patch.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "geometry/measures.h"

namespace crumple::finish {

namespace {

// How far `others` begin beyond where `own` end, along a direction.
double parted(std::span<const Vec3> own, std::span<const Vec3> others, Vec3 along) {
    double end = -1e300;
    double begin = 1e300;
    for (const Vec3 v : own) end = std::max(end, dot(v - own[0], along));
    for (const Vec3 v : others) begin = std::min(begin, dot(v - own[0], along));
    return begin - end;
}

// Whether a plane upright on `normal`, along a side of one of the two, parts them.
bool is_beside(std::span<const Vec3> own, std::span<const Vec3> others, Vec3 normal) {
    for (const std::span<const Vec3> sides : {own, others}) {
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const Vec3 across = cross(sides[(i + 1) % sides.size()] - sides[i], normal);
            if (parted(own, others, across) > 0 || parted(own, others, across * -1) > 0) return true;
        }
    }
    return false;
}

}

bool is_fold_within(Vec3 n, Vec3 m, double sine_2) {
    const Vec3 turn = cross(n, m);
    return dot(n, m) > 0 && dot(turn, turn) <= sine_2 * dot(n, n) * dot(m, m);
}

double gap_between(Vec3 a, Vec3 b, Vec3 p, Vec3 q) {
    const Vec3 across = cross(b - a, q - p);
    const double size = length(across);
    return size > 0 ? std::fabs(dot(p - a, across)) / size : 0;
}

double SurfacePatch::gap() const { return gap_between(a, b, p, q); }

double SurfacePatch::mean_side() const { return (length(p - a) + length(b - p) + length(q - b) + length(a - q)) / 4; }

bool SurfacePatch::is_flat(double sine_2) const {
    return is_fold_within(area_vector(p, b, a), area_vector(a, b, q), sine_2) &&
           is_fold_within(area_vector(a, p, q), area_vector(q, p, b), sine_2);
}

// What comes towards a surface from outside faces it.
bool SurfacePatch::is_clear_of(const std::array<Vec3, 3>& triangle) const {
    const Vec3 outwards = area_vector(a, p, b) + area_vector(a, b, q);
    if (dot(area_vector(triangle[0], triangle[1], triangle[2]), outwards) >= 0) return true;
    const double size = length(outwards);
    if (!(size > 0)) return false;
    const Vec3 normal = outwards / size;
    const std::array<Vec3, 4> corners{a, p, b, q};
    const double margin = gap();
    return parted(corners, triangle, normal) > margin || parted(corners, triangle, normal * -1) > margin ||
           is_beside(corners, triangle, normal);
}

}
