// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/tet_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/index.h"

namespace crumple::quality {

namespace {

// What every measure of a tet is made of.
struct Parts {
    double six_volumes;
    std::array<Vec3, 4> corners;
    std::array<Vec3, 4> normals;      // outward, twice the area of the face opposite the corner
    std::array<double, 4> normals_2;  // squared lengths
    std::array<double, 6> edges_2;    // squared lengths, in the order of tet_edge_corners
};

Parts take_apart(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    Parts parts;
    parts.corners = {a, b, c, d};
    parts.six_volumes = dot(b - a, cross(c - a, d - a));
    for (int face = 0; face < 4; ++face) {
        const auto& at = tet_face_corners[face];
        const Vec3 first = parts.corners[at[0]];
        parts.normals[face] = cross(parts.corners[at[1]] - first, parts.corners[at[2]] - first);
        parts.normals_2[face] = dot(parts.normals[face], parts.normals[face]);
    }
    for (int edge = 0; edge < 6; ++edge) {
        const Vec3 along = parts.corners[tet_edge_corners[edge][1]] - parts.corners[tet_edge_corners[edge][0]];
        parts.edges_2[edge] = dot(along, along);
    }
    return parts;
}

// The angle at an edge lies between the faces opposite the two other corners, which are those of edge 5 - edge:
// sin a = 6 V l / (|n| |m|) with n, m twice the area vectors, cos a = -n.m / (|n| |m|). The sine keeps all its digits
// where an angle is nearly 0 or 180 degrees.
AngleKey dihedral(const Parts& parts, int edge) {
    const int* faces = tet_edge_corners[5 - edge];
    const double n_2 = parts.normals_2[faces[0]];
    const double m_2 = parts.normals_2[faces[1]];
    const double sine_2 = std::min(1.0, parts.six_volumes / n_2 * (parts.six_volumes / m_2) * parts.edges_2[edge]);
    const bool is_acute = dot(parts.normals[faces[0]], parts.normals[faces[1]]) <= 0;
    return is_acute ? sine_2 : 2 - sine_2;
}

double radius_ratio(const Parts& parts) {
    // R = sqrt(s (s - 2p) (s - 2q) (s - 2r)) / (24 V), p, q, r the products of opposite edges and s their sum; r = 3 V
    // / area.
    double area_2 = 0;  // twice the surface
    for (const double n_2 : parts.normals_2) area_2 += std::sqrt(n_2);
    const double p = std::sqrt(parts.edges_2[0] * parts.edges_2[5]);
    const double q = std::sqrt(parts.edges_2[1] * parts.edges_2[4]);
    const double r = std::sqrt(parts.edges_2[2] * parts.edges_2[3]);
    const double sum = p + q + r;
    const double under_root = (q + r - p) * (p + r - q) * (p + q - r) / sum;
    if (!(under_root > 0)) return 0;
    // 3 r / R = 9 V / area * 24 V / (sum sqrt(under_root)), with V = six_volumes / 6 and area = area_2 / 2.
    return 12 * (parts.six_volumes / area_2) * (parts.six_volumes / sum) / std::sqrt(under_root);
}

double volume_lrms3(const Parts& parts) {
    double sum_2 = 0;
    for (const double edge_2 : parts.edges_2) sum_2 += edge_2;
    const double mean_2 = sum_2 / 6;
    return std::numbers::sqrt2 * parts.six_volumes / mean_2 / std::sqrt(mean_2);
}

}

double degrees_of(AngleKey key) {
    const double sine_2 = std::clamp(key <= 1 ? key : 2 - key, 0.0, 1.0);
    const double acute = std::asin(std::sqrt(sine_2)) * (180 / std::numbers::pi);
    return key <= 1 ? acute : 180 - acute;
}

AngleKey min_dihedral_key(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Parts parts = take_apart(a, b, c, d);
    if (!(parts.six_volumes > 0)) return key_of_0_deg;
    AngleKey least = key_of_180_deg;
    for (int edge = 0; edge < 6; ++edge) least = std::min(least, dihedral(parts, edge));
    return least;
}

TetMeasures measure_tet(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Parts parts = take_apart(a, b, c, d);
    TetMeasures measures;
    measures.volume = parts.six_volumes / 6;
    measures.shortest_edge_2 = *std::min_element(parts.edges_2.begin(), parts.edges_2.end());
    measures.longest_edge_2 = *std::max_element(parts.edges_2.begin(), parts.edges_2.end());
    if (!(parts.six_volumes > 0)) return measures;
    measures.min_dihedral = key_of_180_deg;
    measures.max_dihedral = key_of_0_deg;
    for (int edge = 0; edge < 6; ++edge) {
        const AngleKey key = dihedral(parts, edge);
        measures.min_dihedral = std::min(measures.min_dihedral, key);
        measures.max_dihedral = std::max(measures.max_dihedral, key);
    }
    measures.radius_ratio = radius_ratio(parts);
    measures.volume_lrms3 = volume_lrms3(parts);
    return measures;
}

}
