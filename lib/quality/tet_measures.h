// SPDX-License-Identifier: GPL-3.0-or-later
// How good the shape of one tet is. Angles are kept as keys that need no arccosine, so that what is decided on them
// comes out the same on every machine; degrees are for people.
#pragma once
#include "core/vec3.h"

namespace crumple::quality {

// Grows with a dihedral angle a of 0..180 degrees: sin^2 a up to a right angle, 2 - sin^2 a beyond it.
using AngleKey = double;
inline constexpr AngleKey key_of_0_deg = 0;
inline constexpr AngleKey key_of_10_deg = 0.030153689607045808;
inline constexpr AngleKey key_of_180_deg = 2;

[[nodiscard]] double degrees_of(AngleKey key);

// Measures of a tet that is flat or turned inside out: keys 0 and 180 degrees, both ratios 0.
struct TetMeasures {
    double volume = 0;  // signed, cubic metres
    AngleKey min_dihedral = key_of_0_deg;
    AngleKey max_dihedral = key_of_180_deg;
    double radius_ratio = 0;     // 3 inscribed radius / circumscribed radius: 1 for a regular tet
    double volume_lrms3 = 0;     // 6 sqrt(2) volume / (root mean square edge)^3: 1 for a regular tet
    double shortest_edge_2 = 0;  // squared, square metres
    double longest_edge_2 = 0;
};

[[nodiscard]] TetMeasures measure_tet(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

// Only TetMeasures::min_dihedral, for loops that ask often.
[[nodiscard]] AngleKey min_dihedral_key(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

}
