// SPDX-License-Identifier: MIT
// Elements refer to each other by 32-bit index, never by pointer.
#pragma once
#include <array>
#include <cstdint>

namespace crumple {

using Index = std::uint32_t;
inline constexpr Index none = 0xffffffffu;

using Edge = std::array<Index, 2>;
using Triangle = std::array<Index, 3>;  // counter-clockwise seen from outside
using Tet = std::array<Index, 4>;       // orient3d(corner 0, 1, 2, 3) > 0

inline bool share_a_corner(const Triangle& a, const Triangle& b) {
    for (const Index v : a) {
        if (v == b[0] || v == b[1] || v == b[2]) return true;
    }
    return false;
}

// The face opposite corner i of a positive tet, counter-clockwise seen from outside the tet.
inline constexpr int tet_face_corners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
inline constexpr int tet_edge_corners[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

}
