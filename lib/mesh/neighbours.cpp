// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/neighbours.h"

#include <algorithm>

#include "core/error.h"

namespace crumple {

namespace {

struct Side {
    Triangle corners;  // sorted
    Index tet = none;
    std::uint8_t face = 0;
};

std::vector<Side> sorted_sides(std::span<const Tet> tets) {
    std::vector<Side> sides;
    sides.reserve(tets.size() * 4);
    for (Index t = 0; t < tets.size(); ++t) {
        for (std::uint8_t face = 0; face < 4; ++face) {
            const auto& corner = tet_face_corners[face];
            Triangle corners{tets[t][corner[0]], tets[t][corner[1]], tets[t][corner[2]]};
            std::sort(corners.begin(), corners.end());
            sides.push_back({corners, t, face});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return a.corners != b.corners ? a.corners < b.corners : a.tet < b.tet;
    });
    return sides;
}

}

std::vector<std::array<Index, 4>> neighbours_of(std::span<const Tet> tets) {
    std::vector<std::array<Index, 4>> neighbours(tets.size(), {none, none, none, none});
    const std::vector<Side> sides = sorted_sides(tets);
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const Side& a = sides[i - 1];
        const Side& b = sides[i];
        if (a.corners != b.corners) continue;
        CRUMPLE_CHECK(i < 2 || sides[i - 2].corners != a.corners, "at most two tets share a face");
        neighbours[a.tet][a.face] = b.tet;
        neighbours[b.tet][b.face] = a.tet;
    }
    return neighbours;
}

}
