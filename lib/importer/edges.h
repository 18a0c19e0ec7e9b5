// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of triangles, each with the triangles on it.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/index.h"

namespace crumple::importer {

// One side of a triangle: from corner `side` to the next.
struct HalfEdge {
    Index low = 0;  // the smaller of its two vertices
    Index high = 0;
    Index triangle = 0;
    std::uint8_t side = 0;
    bool ascends = true;  // runs from low to high in its triangle
};

// All half-edges, those of one edge side by side: edges ascending, then by triangle.
inline std::vector<HalfEdge> sorted_half_edges(std::span<const Triangle> triangles) {
    std::vector<HalfEdge> half_edges;
    half_edges.reserve(3 * triangles.size());
    for (Index t = 0; t < triangles.size(); ++t) {
        for (std::uint8_t side = 0; side < 3; ++side) {
            const Index a = triangles[t][side];
            const Index b = triangles[t][(side + 1) % 3];
            half_edges.push_back({std::min(a, b), std::max(a, b), t, side, a < b});
        }
    }
    std::sort(half_edges.begin(), half_edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
        if (a.low != b.low) return a.low < b.low;
        if (a.high != b.high) return a.high < b.high;
        return a.triangle != b.triangle ? a.triangle < b.triangle : a.side < b.side;
    });
    return half_edges;
}

// Calls visit(span of HalfEdge) once an edge.
template <class Visit>
void for_each_edge(std::span<const HalfEdge> sorted, Visit&& visit) {
    for (std::size_t begin = 0; begin < sorted.size();) {
        std::size_t end = begin + 1;
        while (end < sorted.size() && sorted[end].low == sorted[begin].low && sorted[end].high == sorted[begin].high)
            ++end;
        visit(sorted.subspan(begin, end - begin));
        begin = end;
    }
}

// The same, component by component: visit(component, span of HalfEdge).
template <class Visit>
void for_each_component_edge(std::span<const HalfEdge> sorted, std::span<const Index> of_triangle, Visit&& visit) {
    const auto component = [&](const HalfEdge& side) { return of_triangle[side.triangle]; };
    std::vector<HalfEdge> sides;
    for_each_edge(sorted, [&](std::span<const HalfEdge> edge) {
        sides.assign(edge.begin(), edge.end());
        std::stable_sort(sides.begin(), sides.end(),
                         [&](const HalfEdge& a, const HalfEdge& b) { return component(a) < component(b); });
        for (std::size_t begin = 0; begin < sides.size();) {
            std::size_t end = begin + 1;
            while (end < sides.size() && component(sides[end]) == component(sides[begin])) ++end;
            visit(component(sides[begin]), std::span<const HalfEdge>(sides).subspan(begin, end - begin));
            begin = end;
        }
    });
}

}
