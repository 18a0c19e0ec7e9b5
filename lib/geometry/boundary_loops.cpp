// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/boundary_loops.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace crumple {

namespace {

struct SidedEdge {
    Edge ends;  // ascending
    int times;  // +1 from the first to the second end, -1 back
};

// Directed edges left over when every pair of opposite ones is taken away, ascending.
std::vector<Edge> unmatched_edges(std::span<const Triangle> triangles) {
    std::vector<SidedEdge> edges;
    edges.reserve(triangles.size() * 3);
    for (const Triangle& t : triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            const Index from = t[corner];
            const Index to = t[(corner + 1) % 3];
            edges.push_back({{std::min(from, to), std::max(from, to)}, from < to ? 1 : -1});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const SidedEdge& a, const SidedEdge& b) { return a.ends < b.ends; });
    std::vector<Edge> unmatched;
    for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
        int times = 0;
        for (; next < edges.size() && edges[next].ends == edges[i].ends; ++next) times += edges[next].times;
        const auto [low, high] = edges[i].ends;
        unmatched.insert(unmatched.end(), static_cast<std::size_t>(std::abs(times)),
                         times > 0 ? Edge{low, high} : Edge{high, low});
    }
    std::sort(unmatched.begin(), unmatched.end());
    return unmatched;
}

}

// A boundary enters every vertex as often as it leaves it, so walking along unused edges always comes back to the
// start.
std::vector<std::vector<Index>> boundary_loops(std::span<const Triangle> triangles) {
    const std::vector<Edge> edges = unmatched_edges(triangles);
    std::vector<std::uint8_t> is_used(edges.size(), 0);
    const auto unused_from = [&](Index vertex) {
        auto at =
            static_cast<std::size_t>(std::lower_bound(edges.begin(), edges.end(), Edge{vertex, 0}) - edges.begin());
        while (at < edges.size() && edges[at][0] == vertex && is_used[at]) ++at;
        return at < edges.size() && edges[at][0] == vertex ? at : edges.size();
    };
    std::vector<std::vector<Index>> loops;
    for (std::size_t start = 0; start < edges.size(); ++start) {
        if (is_used[start]) continue;
        std::vector<Index> loop;
        for (std::size_t at = start; at < edges.size(); at = unused_from(edges[at][1])) {
            is_used[at] = 1;
            loop.push_back(edges[at][0]);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

}
