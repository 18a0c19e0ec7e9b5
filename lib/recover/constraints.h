// SPDX-License-Identifier: GPL-3.0-or-later
// What of the shell has to be in the tets: its edges as segments, its triangles as facets. Both can be split at a node,
// and a split can be taken back.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/index.h"

namespace crumple::recover {

// Ascending.
[[nodiscard]] Edge sorted_edge(Index a, Index b);
[[nodiscard]] Triangle sorted_triangle(Index a, Index b, Index c);

struct EdgeHash {
    std::size_t operator()(const Edge& e) const noexcept;
};
struct TriangleHash {
    std::size_t operator()(const Triangle& t) const noexcept;
};

// A segment or facet is named by its nodes, ascending.
class Constraints {
public:
    // Triangles with an edge of no length are left out, copies are one facet.
    void add_facet(const Triangle& facet, Index origin);

    [[nodiscard]] bool has_segment(Index a, Index b) const { return segments_.contains(sorted_edge(a, b)); }
    [[nodiscard]] bool has_facet(Index a, Index b, Index c) const { return facets_.contains(sorted_triangle(a, b, c)); }
    // The shell triangle a facet is (a part of).
    [[nodiscard]] Index origin(const Triangle& facet) const { return facets_.at(facet); }
    // The third nodes of the facets at a segment, ascending.
    [[nodiscard]] const std::vector<Index>& apexes(const Edge& segment) const { return segments_.at(segment); }

    // In ascending order.
    [[nodiscard]] std::vector<Edge> segments() const;
    [[nodiscard]] std::vector<Triangle> facets() const;

    void remove_facet(const Triangle& facet);

private:
    void add_apex(Index a, Index b, Index apex);
    void remove_apex(Index a, Index b, Index apex);

    std::unordered_map<Edge, std::vector<Index>, EdgeHash> segments_;  // only looked up, or sorted before use
    std::unordered_map<Triangle, Index, TriangleHash> facets_;
};

}
