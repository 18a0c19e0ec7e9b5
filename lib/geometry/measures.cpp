// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/measures.h"

namespace crumple {

// Cramer's rule relative to a: whatever the rounding of the other three weights, the sum is 1 and the place that the
// weights describe stays near p even far from the origin.
std::array<double, 4> barycentric(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 p) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 ad = d - a;
    const Vec3 ap = p - a;
    const Vec3 normal_b = cross(ac, ad);
    const double six_volumes = dot(ab, normal_b);
    const double weight_b = dot(ap, normal_b) / six_volumes;
    const double weight_c = dot(ap, cross(ad, ab)) / six_volumes;
    const double weight_d = dot(ap, cross(ab, ac)) / six_volumes;
    return {1 - weight_b - weight_c - weight_d, weight_b, weight_c, weight_d};
}

Vec3 circumcentre(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 ad = d - a;
    const Vec3 offset = cross(ac, ad) * dot(ab, ab) + cross(ad, ab) * dot(ac, ac) + cross(ab, ac) * dot(ad, ad);
    return a + offset / (2 * dot(ab, cross(ac, ad)));
}

namespace {

ClosestOnTriangle closest_on_segment(Vec3 a, Vec3 b, Vec3 p, unsigned bit_a, unsigned bit_b) {
    const Vec3 ab = b - a;
    const double along = dot(p - a, ab);
    const double whole = dot(ab, ab);
    if (!(along > 0)) return {a, bit_a};
    if (along >= whole) return {b, bit_b};
    return {a + ab * (along / whole), bit_a | bit_b};
}

const ClosestOnTriangle& nearer(Vec3 p, const ClosestOnTriangle& q, const ClosestOnTriangle& r) {
    return dot(q.point - p, q.point - p) <= dot(r.point - p, r.point - p) ? q : r;
}

}

ClosestOnTriangle closest_on_triangle(Vec3 a, Vec3 b, Vec3 c, Vec3 p) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 normal = cross(ab, ac);
    const double area_2 = dot(normal, normal);
    // Signed areas of p's projection against each edge, times |normal|.
    const double beyond_c = dot(cross(ab, p - a), normal);
    const double beyond_b = dot(cross(p - a, ac), normal);
    const double beyond_a = area_2 - beyond_b - beyond_c;
    if (area_2 > 0 && beyond_a > 0 && beyond_b > 0 && beyond_c > 0) {
        return {a + ab * (beyond_b / area_2) + ac * (beyond_c / area_2), 7};
    }
    // The nearest point lies on an edge that faces p; without area every edge may.
    const bool is_flat = !(area_2 > 0);
    ClosestOnTriangle closest{{}, 0};
    const auto offer = [&](const ClosestOnTriangle& other) {
        closest = closest.corners == 0 ? other : nearer(p, closest, other);
    };
    if (is_flat || beyond_c <= 0) offer(closest_on_segment(a, b, p, 1, 2));
    if (is_flat || beyond_a <= 0) offer(closest_on_segment(b, c, p, 2, 4));
    if (is_flat || beyond_b <= 0) offer(closest_on_segment(c, a, p, 4, 1));
    return closest.corners == 0 ? ClosestOnTriangle{a, 1} : closest;
}

}
