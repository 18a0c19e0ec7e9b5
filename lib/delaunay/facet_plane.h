// SPDX-License-Identifier: GPL-3.0-or-later
// The plane of a facet of the lifted hull, as a float filter: its side of a point is the in-sphere test of the facet's
// tet (or the orientation test, for a facet that reaches infinity).
//
// With the newest vertex q as origin, a, b, c the other corners and p the query, all relative to q,
//
//     s(p) = N . p + D |p|^2,   N = |a|^2 (b x c) + |b|^2 (c x a) + |c|^2 (a x b),   D = -a . (b x c)
//
// is positive exactly when p lies inside the circumsphere of the positive tet (q, a, b, c). The vertex at infinity is
// the vector 0 with squared length 1: the same formula then gives the plane of the three finite corners, D = 0.
//
// Proof of the bound, u = 2^-53, m_a the largest component of a, coordinates at most 2 and their differences at least
// 2^-452 where they are not zero (make_sites sees to that):
// - a monomial of N passes through at most 12 roundings (5 in |a|^2, 4 in the cross product, 1 + 2 after), one of D
//   through 8. |N - N'| <= 16 u * 2 (|a|^2 m_b m_c + |b|^2 m_c m_a + |c|^2 m_a m_b), |D - D'| <= 10 u * 6 m_a m_b m_c.
// - Products that underflow lose 2^-1075 each, times at most 2^12: nothing, as planes with max |N| < 2^-400 are not
// used.
// - N and D are divided by max |N| and rounded to float: an error of 2^-25 where |N| <= 1, of 2^-24 |D|. A D beyond
// 2^100
//   is not used; a float underflow of D loses 2^-150 at most, and |p|^2 <= 48.
// - Evaluating s in double takes at most 10 roundings a monomial: 10 u (|p|_1 + |D| |p|^2).
// A plane that is not used has an infinite bound: the exact rungs decide.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace crumple::delaunay {

struct FacetPlane {
    std::array<float, 3> normal;
    float curvature;
    float normal_error;
    float curvature_error;

    // s of the point at d from the plane's origin.
    [[nodiscard]] double height(double dx, double dy, double dz) const {
        return normal[0] * dx + normal[1] * dy + normal[2] * dz + curvature * (dx * dx + dy * dy + dz * dz);
    }

    // +1 the point certainly sees the facet, -1 it certainly does not, 0 ask the exact predicates.
    [[nodiscard]] int side(double dx, double dy, double dz) const {
        const double square = dx * dx + dy * dy + dz * dz;
        const double value = normal[0] * dx + normal[1] * dy + normal[2] * dz + curvature * square;
        const double bound = normal_error * (std::fabs(dx) + std::fabs(dy) + std::fabs(dz)) + curvature_error * square;
        return (value > bound) - (value < -bound);
    }
};

// The vertices of a star relative to its newest vertex, V entries each.
struct StarVertices {
    std::vector<double> x, y, z;
    std::vector<double> square;   // squared length; 1 for the vertex at infinity
    std::vector<double> largest;  // largest component

    void resize(std::size_t count);
    void set(std::size_t i, double dx, double dy, double dz);
    void set_infinite(std::size_t i);
};

// The facets of a star: three numbers of StarVertices and the plane each, F entries, structure of arrays for SIMD.
struct StarPlanes {
    std::array<std::vector<std::uint32_t>, 3> corner;
    std::array<std::vector<float>, 3> normal;
    std::vector<float> curvature, normal_error, curvature_error;

    void resize(std::size_t count);
    [[nodiscard]] FacetPlane operator[](std::size_t i) const {
        return {{normal[0][i], normal[1][i], normal[2][i]}, curvature[i], normal_error[i], curvature_error[i]};
    }
};

// Fills planes [0, count) from their corners. The same bits with any instruction set.
void make_planes(const StarVertices& vertices, StarPlanes& planes, std::size_t count);

}
