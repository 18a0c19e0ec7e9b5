// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/shape.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/index.h"

namespace crumple::finish {

namespace {

struct Faces {
    Vec3 normal[4];      // inward, twice the area of the face opposite the corner
    double area_2[4];    // their squared lengths
    double six_volumes;  // positive where orient3d is
};

Faces faces_of(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 p = b - a;
    const Vec3 q = c - a;
    const Vec3 r = d - a;
    Faces faces;
    faces.normal[0] = cross(d - b, c - b);
    faces.normal[1] = cross(q, r);
    faces.normal[2] = cross(r, p);
    faces.normal[3] = cross(p, q);
    for (int i = 0; i < 4; ++i) faces.area_2[i] = dot(faces.normal[i], faces.normal[i]);
    faces.six_volumes = dot(p, faces.normal[1]);
    return faces;
}

double squared(Vec3 a) { return dot(a, a); }

// 12 (3 V)^(2/3) over the sum of squared edges: 1 for a regular tet.
double mean_ratio(double six_volumes, double edges_2) {
    return 12 * cube_root(six_volumes * six_volumes * 0.25) / edges_2;
}

// The mean ratio as it counts, and the power of it that this is nearby: d ln(value) / d ln(ratio).
struct Weighted {
    double value;
    double power;
};

Weighted weighted(double ratio) {
    if (ratio >= long_ratio || ratio <= flat_ratio) return {mean_ratio_weight * ratio, 1};
    if (ratio >= needle_ratio) return {mean_ratio_weight * std::sqrt(ratio * long_ratio), 0.5};
    const double at_needle = std::sqrt(needle_ratio * long_ratio);
    const double slope = (at_needle - flat_ratio) / (needle_ratio - flat_ratio);
    const double value = flat_ratio + slope * (ratio - flat_ratio);
    return {mean_ratio_weight * value, slope * ratio / value};
}

}

double cube_root(double x) {
    // A third of the exponent gives two digits, each Halley step three times as many.
    double y = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) / 3 + 0x2a9f7893782da1ceull);
    for (int step = 0; step < 3; ++step) {
        const double cube = y * y * y;
        y *= (cube + 2 * x) / (2 * cube + x);
    }
    return y;
}

double shape_of(Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return OppositeFace(b, c, d).shape_from(a); }

OppositeFace::OppositeFace(Vec3 b, Vec3 c, Vec3 d)
    : corners_{b, c, d},
      normal_(cross(d - b, c - b)),
      inverse_area_2_(1 / squared(normal_)),
      edges_2_{squared(c - b), squared(d - b), squared(d - c)} {}

double OppositeFace::shape_from(Vec3 node) const {
    const Vec3 p = corners_[0] - node;
    const Vec3 q = corners_[1] - node;
    const Vec3 r = corners_[2] - node;
    const Vec3 normal[4] = {normal_, cross(q, r), cross(r, p), cross(p, q)};
    const double six_volumes = dot(p, normal[1]);
    if (!(six_volumes > 0)) return 0;
    const double inverse[4] = {inverse_area_2_, 1 / squared(normal[1]), 1 / squared(normal[2]), 1 / squared(normal[3])};
    const double edge_2[6] = {squared(p), squared(q), squared(r), edges_2_[0], edges_2_[1], edges_2_[2]};
    double least = 1e300;
    double sum_2 = 0;
    for (int edge = 0; edge < 6; ++edge) {
        // The angle at an edge lies between the faces opposite the two other corners: sine = 6 V l / (|n| |m|).
        const int* face = tet_edge_corners[5 - edge];
        sum_2 += edge_2[edge];
        double sine_2 = edge_2[edge] * inverse[face[0]] * inverse[face[1]];
        if (dot(normal[face[0]], normal[face[1]]) > 0) sine_2 *= obtuse_bias * obtuse_bias;
        least = std::min(least, sine_2);
    }
    const double sine = six_volumes * std::sqrt(least);
    if (!(sine > 0)) return 0;
    // The mean ratio wants a cube root: take it only where it could be the smaller one.
    const double scale = 12 * mean_ratio_weight;
    const double cubed = scale * scale * scale * 0.25 * six_volumes * six_volumes;
    if (cubed > sine * sine * sine * (sum_2 * sum_2 * sum_2) * 1.0000001) return sine;
    return std::min(sine, weighted(mean_ratio(six_volumes, sum_2)).value);
}

ShapeTerms shape_terms(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Faces faces = faces_of(a, b, c, d);
    const Vec3 corners[4] = {a, b, c, d};
    // Logarithmic derivatives with respect to a: of the volume, of squared areas halved, of edges halved.
    const Vec3 of_volume = faces.normal[0] / faces.six_volumes;
    Vec3 of_area[4] = {};
    for (int i = 1; i < 4; ++i) {
        // The face opposite corner i holds a and the two others p, q: d|n|^2 = 2 da . ((p - q) x n), n = (p - a) x (q -
        // a).
        const Vec3 p = corners[i == 1 ? 2 : i == 2 ? 3 : 1];
        const Vec3 q = corners[i == 1 ? 3 : i == 2 ? 1 : 2];
        of_area[i] = cross(p - q, faces.normal[i]) / faces.area_2[i];
    }
    ShapeTerms terms;
    double edges_2 = 0;
    for (int edge = 0; edge < 6; ++edge) {
        const int* face = tet_edge_corners[5 - edge];
        const Vec3 along = corners[tet_edge_corners[edge][1]] - corners[tet_edge_corners[edge][0]];
        const double edge_2 = squared(along);
        edges_2 += edge_2;
        const double areas_2 = faces.area_2[face[0]] * faces.area_2[face[1]];
        double sine = faces.six_volumes * std::sqrt(edge_2 / areas_2);
        if (dot(faces.normal[face[0]], faces.normal[face[1]]) > 0) sine *= obtuse_bias;
        Vec3 change = of_volume - of_area[face[0]] - of_area[face[1]];
        if (edge < 3) change -= along / edge_2;  // the edges at a come first
        terms.value[edge] = sine;
        terms.gradient[edge] = change * sine;
    }
    const Vec3 of_edges = (a * 3 - b - c - d) * 2 / edges_2;
    const Weighted ratio = weighted(mean_ratio(faces.six_volumes, edges_2));
    terms.value[6] = ratio.value;
    terms.gradient[6] = (of_volume * (2.0 / 3) - of_edges) * (ratio.power * ratio.value);
    return terms;
}

double shape_of_angle(double degrees) {
    // Taylor's series of the sine to x^15: better than a double's last places up to 90 degrees.
    const double x = std::clamp(degrees, 0.0, 90.0) * (std::numbers::pi / 180);
    double term = x;
    double sum = x;
    for (int n = 3; n <= 21; n += 2) {
        term *= -x * x / (n * (n - 1));
        sum += term;
    }
    return sum;
}

}
