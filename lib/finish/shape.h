// SPDX-License-Identifier: GPL-3.0-or-later
// How good one tet is, in the single number that finish raises: the smaller of the biased sine of its worst dihedral
// angle [Klingner and Shewchuk 2007, "Aggressive tetrahedral mesh improvement"] and 1.3 times its mean ratio [Liu and
// Joe 1994]. The sine alone lets short fat slivers pass, the mean ratio alone gives away the smallest angle. Between
// long and flat a tet's mean ratio counts by its root: one that a needle of the shell makes long may have fair angles
// all the same. Nothing here needs libm beyond the square root, so decisions come out the same on every machine.
#pragma once
#include <array>

#include "core/vec3.h"

namespace crumple::finish {

// Sines of angles beyond 90 degrees count this much: a large angle costs more than a small one of the same sine.
inline constexpr double obtuse_bias = 0.7;
inline constexpr double mean_ratio_weight = 1.3;

// Mean ratios: below the first a tet is long, down to the second by its root, below the third as flat as it says.
inline constexpr double long_ratio = 0.25;
inline constexpr double needle_ratio = 0.0625;
inline constexpr double flat_ratio = 0.03;

// About 0.94 for a regular tet, at most 1; 0 for a tet that is flat or turned inside out.
[[nodiscard]] double shape_of(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

// The face opposite a node in one tet at it: (node, face[0], face[1], face[2]) is positive. Holds what the tets of all
// places of the node share, for searches that ask for many.
class OppositeFace {
public:
    OppositeFace(Vec3 b, Vec3 c, Vec3 d);
    [[nodiscard]] const Vec3& operator[](int i) const { return corners_[i]; }

    // shape_of(node, face[0], face[1], face[2]), to the bit.
    [[nodiscard]] double shape_from(Vec3 node) const;

private:
    std::array<Vec3, 3> corners_;
    Vec3 normal_;            // towards the node, twice the area
    double inverse_area_2_;  // 1 / its squared length
    double edges_2_[3];      // squared: 0 to 1, 0 to 2, 1 to 2
};

// The seven functions whose minimum the shape is, and how they change as corner a moves. A positive tet only.
struct ShapeTerms {
    double value[7];   // six biased sines in the order of tet_edge_corners, then the weighted mean ratio
    Vec3 gradient[7];  // with respect to a
};
[[nodiscard]] ShapeTerms shape_terms(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

// The shape that a smallest angle of so many degrees allows at best: its sine, without libm. 0..90.
[[nodiscard]] double shape_of_angle(double degrees);

// x^(1/3) of a positive normal number to a few units of the last place, the same bits everywhere.
[[nodiscard]] double cube_root(double x);

}
