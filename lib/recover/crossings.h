// SPDX-License-Identifier: GPL-3.0-or-later
// What lies in the way of a segment or a facet: the faces, edges and nodes of the tets that it passes through. Exact.
#pragma once
#include <array>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"
#include "mesh/tet_complex.h"

namespace crumple::recover {

// A face (3 nodes), an edge (2) or a node (1) that an open segment passes through, the face in its inside.
struct Crossing {
    std::array<Index, 3> nodes{none, none, none};
    int count = 0;
    Index tet = none;  // that has it, on the side the segment comes from
};

// In the order from a to b; empty when (a, b) is an edge. Ends at the first node in the way.
// REQUIRES: both in tets that fill a convex region.
void crossings_of_segment(const TetComplex& complex, Index a, Index b, std::vector<Crossing>& crossings);

struct PiercingEdge {
    Edge nodes;  // ascending
    Index tet;   // that has it
};

// What keeps a triangle from being faces of the tets: edges through its inside, or a node in it.
struct FacetObstacles {
    std::vector<PiercingEdge> edges;
    Index node = none;  // lies in the facet; then the edges are not all told
};

// REQUIRES: its three edges are edges of the tets.
void obstacles_of_facet(const TetComplex& complex, const Triangle& facet, FacetObstacles& obstacles);

// Likewise, whether its edges are there or not; takes longer.
void obstacles_of_any_facet(const TetComplex& complex, const Triangle& facet, FacetObstacles& obstacles);

// Whether the open segment (a, b) passes through the inside of the triangle.
[[nodiscard]] bool pierces(Vec3 a, Vec3 b, Vec3 p, Vec3 q, Vec3 r);

// Whether two open segments of one plane meet in one inner point of both.
[[nodiscard]] bool segments_cross(Vec3 a, Vec3 b, Vec3 p, Vec3 q);

}
