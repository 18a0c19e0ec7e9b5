// SPDX-License-Identifier: MIT
// The shape of the sample car's body: its cross-section at every station along the length. X is left, Y up, Z forward;
// the ground is y = 0.
#pragma once
#include <array>

#include "core/vec3.h"

namespace crumple::samples::car {

inline constexpr double nose_z = 2.15;
inline constexpr double tail_z = -2.15;
inline constexpr double axle_z[2] = {1.30, -1.28};  // front, rear
inline constexpr double wheel_radius = 0.31;
inline constexpr double wheel_middle_x = 0.70;

// Control points of the left half of a cross-section, from the middle of the floor around the side to the middle of the
// roof; the curve through a whole section is spline(points, u), u in [0, section_points - 1].
inline constexpr int section_points = 8;
using Section = std::array<Vec3, section_points>;
enum SectionPoint { floor_middle, floor_side, sill, flank, belt, cant, crown, roof_middle };

// What the eye sees.
[[nodiscard]] Section body_section(double z);

// The same, grown by the margin that a control shell keeps around what it carries, and reaching down around the wheels.
inline constexpr double shell_margin = 0.065;
[[nodiscard]] Section shell_section(double z);

}
