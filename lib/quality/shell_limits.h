// SPDX-License-Identifier: GPL-3.0-or-later
// Which bad corners the shell itself forces: what the artist would have to remodel, told apart from what we failed at.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/index.h"
#include "core/vec3.h"

namespace crumple::quality {

enum class ShellLimit : std::uint8_t {
    none,
    thin,    // t thick and e long, a place allows no angle above atan(t / e), and the tet reaches 0.9 of that
    needle,  // a face is a surface triangle of a yet smaller corner
    gap,     // the surface comes so near to itself there, on either side, and the tet reaches 0.9 of what that allows;
             // or so near that it is hardly more than rounding
};
inline constexpr EnumName<ShellLimit> shell_limit_names[] = {
    {ShellLimit::none, "none"}, {ShellLimit::thin, "thin"}, {ShellLimit::needle, "needle"}, {ShellLimit::gap, "gap"}};
constexpr std::span<const EnumName<ShellLimit>> enum_names(ShellLimit) { return shell_limit_names; }

// A closed surface over nodes of the mesh: the shell's, or the tets' own.
struct Surface {
    std::span<const Vec3> positions;
    std::span<const Triangle> triangles;
};

inline constexpr double bad_angle_deg = 10;

// T: why a tet is below that angle, an acute one; none for one that is not, or without excuse. t is the diameter of the
// largest ball inside that touches the middle of a triangle, its mean over the triangles around the tet's corners, e
// the mean edge there. For a gap t is how far the middle of a triangle is from the next surface before or behind it.
[[nodiscard]] std::vector<ShellLimit> find_limits(const Surface& surface, std::span<const Vec3> positions,
                                                  std::span<const Tet> tets, const Context& context = {},
                                                  double below_deg = bad_angle_deg);

}
