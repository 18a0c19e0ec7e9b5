// SPDX-License-Identifier: GPL-3.0-or-later
// The best way to fill the space around an edge without the edge: of all triangulations of the ring of nodes around it
// the one whose worst tet is best, by dynamic programming over sub-polygons [Klincsek 1980, "Minimal triangulations of
// polygonal domains"; for tets Shewchuk 2002, "Two discrete optimization algorithms for the topological improvement of
// tetrahedral meshes"].
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/vec3.h"

namespace crumple::finish {

// Longer rings are left alone: their best triangulation hardly ever pays, and the work grows with the cube.
inline constexpr int max_ring = 12;

struct RingTriangulation {
    // n - 2 triangles (i, j, k), i < j < k, of ring positions: each stands for the tets (i, j, k, b) and (i, k, j, a).
    std::vector<std::array<int, 3>> triangles;
    double least = 0;  // shape of the worst of those tets
};

// ring: n places around the edge from a to b, so that (a, b, ring[i], ring[i + 1]) is positive; last and first are
// joined by an edge in any case. False when every triangulation has a tet whose shape is `floor` or less, when n < 3 or
// when n > max_ring.
[[nodiscard]] bool triangulate_ring(Vec3 a, Vec3 b, std::span<const Vec3> ring, double floor, RingTriangulation& best);

}
