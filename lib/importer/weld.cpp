// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/weld.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "geometry/measures.h"
#include "importer/edges.h"

namespace crumple::importer {

namespace {

// The order in which vertices count as first: the file's.
std::vector<Index> file_order(const Surface& surface) {
    std::vector<Index> order(surface.positions.size());
    std::iota(order.begin(), order.end(), 0u);
    if (!surface.has_vertex_list) return order;
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return surface.source_vertex[a] < surface.source_vertex[b]; });
    return order;
}

// copy_of[v]: the number of v's position, numbered by first appearance in `order`.
std::vector<Index> number_positions(const Surface& surface, const std::vector<Index>& order, Index& count) {
    std::vector<Index> rank(order.size());
    for (Index i = 0; i < order.size(); ++i) rank[order[i]] = i;
    std::vector<Index> by_position = order;
    std::sort(by_position.begin(), by_position.end(), [&](Index a, Index b) {
        if (surface.positions[a] != surface.positions[b])
            return lexicographic_less(surface.positions[a], surface.positions[b]);
        return rank[a] < rank[b];
    });
    std::vector<Index> first(order.size());
    for (std::size_t i = 0; i < by_position.size(); ++i) {
        const bool repeats = i > 0 && surface.positions[by_position[i]] == surface.positions[by_position[i - 1]];
        first[by_position[i]] = repeats ? first[by_position[i - 1]] : by_position[i];
    }
    std::vector<Index> number(order.size(), none);
    count = 0;
    for (const Index v : order) {
        if (first[v] == v) number[v] = count++;
    }
    std::vector<Index> copy_of(order.size());
    for (const Index v : order) copy_of[v] = number[first[v]];
    return copy_of;
}

std::vector<Triangle> renumber(const std::vector<Triangle>& triangles, const std::vector<Index>& copy_of) {
    std::vector<Triangle> result;
    result.reserve(triangles.size());
    for (const Triangle& t : triangles) result.push_back({copy_of[t[0]], copy_of[t[1]], copy_of[t[2]]});
    return result;
}

std::vector<Index> vertices_of_open_edges(const std::vector<Triangle>& triangles) {
    std::vector<Index> vertices;
    const auto half_edges = sorted_half_edges(triangles);
    for_each_edge(half_edges, [&](std::span<const HalfEdge> edge) {
        if (edge.size() % 2 == 0 || edge[0].low == edge[0].high) return;
        vertices.push_back(edge[0].low);
        vertices.push_back(edge[0].high);
    });
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

double reach_of(const std::vector<Vec3>& positions, double tolerance) {
    const Box box = bounding_box(positions);
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis)
        largest = std::max({largest, std::fabs(box.low[axis]), std::fabs(box.high[axis])});
    const double four_ulp = 4 * largest * std::numeric_limits<float>::epsilon();
    return std::max(tolerance * box.diagonal(), four_ulp);
}

// The vertices that others may join, in cells as wide as the reach. They are more than the reach apart, so a cell holds
// few.
class NearbyVertices {
public:
    NearbyVertices(const std::vector<Vec3>& positions, double reach) : positions_(positions), reach_(reach) {}

    void add(Index v) { cells_[cell_of(positions_[v])].push_back(v); }

    // The nearest to v within the reach, the smaller of equally near ones; v itself where there is none.
    [[nodiscard]] Index nearest(Index v) const {
        Index best = v;
        double nearest = reach_;
        const Cell centre = cell_of(positions_[v]);
        for (int neighbour = 0; neighbour < 27; ++neighbour) {
            const Cell cell{centre.x + neighbour % 3 - 1, centre.y + neighbour / 3 % 3 - 1,
                            centre.z + neighbour / 9 - 1};
            const auto found = cells_.find(cell);
            if (found == cells_.end()) continue;
            for (const Index other : found->second) {
                const double distance = length(positions_[other] - positions_[v]);
                if (distance > nearest || (distance == nearest && other > best)) continue;
                nearest = distance;
                best = other;
            }
        }
        return best;
    }

private:
    using Cell = Vec3T<std::int64_t>;
    struct CellHash {
        std::size_t operator()(const Cell& cell) const {
            std::uint64_t hash = 0;
            for (int axis = 0; axis < 3; ++axis) {
                hash = (hash ^ static_cast<std::uint64_t>(cell[axis])) * 0x9e3779b97f4a7c15u;
                hash ^= hash >> 32;
            }
            return static_cast<std::size_t>(hash);
        }
    };
    [[nodiscard]] Cell cell_of(Vec3 p) const {
        const auto along = [&](double x) { return static_cast<std::int64_t>(std::floor(x / reach_)); };
        return {along(p.x), along(p.y), along(p.z)};
    }

    const std::vector<Vec3>& positions_;
    double reach_;
    std::unordered_map<Cell, std::vector<Index>, CellHash> cells_;
};

// target[i]: the vertex that i joins. Only earlier vertices that joined nobody are joined, so no chain drags a vertex
// farther than the reach.
std::vector<Index> join_near(const std::vector<Vec3>& positions, const std::vector<Index>& candidates, double reach) {
    std::vector<Index> target(positions.size());
    std::iota(target.begin(), target.end(), 0u);
    if (!(reach > 0)) return target;
    NearbyVertices nearby(positions, reach);
    for (const Index v : candidates) {  // ascending: the file's order
        target[v] = nearby.nearest(v);
        if (target[v] == v) nearby.add(v);
    }
    return target;
}

// Keeps the numbering by first appearance: a joined vertex is always later than the one it joins.
std::vector<Index> close_gaps(const std::vector<Index>& target, Index& count) {
    std::vector<Index> number(target.size());
    count = 0;
    for (Index i = 0; i < target.size(); ++i) number[i] = target[i] == i ? count++ : number[target[i]];
    return number;
}

std::vector<Vec3> positions_of(const Surface& surface, const std::vector<Index>& copy_of, Index count) {
    std::vector<Vec3> positions(count);
    for (std::size_t v = 0; v < copy_of.size(); ++v) positions[copy_of[v]] = surface.positions[v];
    return positions;
}

void merge_by_tolerance(const Surface& surface, double tolerance, std::vector<Index>& copy_of, Index& count,
                        Welded& welded) {
    const auto candidates = vertices_of_open_edges(renumber(surface.triangles, copy_of));
    if (candidates.empty()) return;
    const auto positions = positions_of(surface, copy_of, count);
    const auto target = join_near(positions, candidates, reach_of(positions, tolerance));
    for (Index i = 0; i < target.size(); ++i) {
        if (target[i] == i) continue;
        ++welded.tolerance_merges;
        welded.farthest = std::max(welded.farthest, length(positions[i] - positions[target[i]]));
    }
    const auto number = close_gaps(target, count);
    for (Index& copy : copy_of) copy = number[copy];
}

// What the copies of each vertex say, first copies first.
void gather(const Surface& surface, const PaintedVertices& painted, const std::vector<Index>& order,
            const std::vector<Index>& copy_of, Index count, Welded& welded) {
    std::vector<Index> first_copy(count, none);
    std::vector<bool> has_free(count, false);
    std::vector<bool> has_color(count, false);
    welded.positions.resize(count);
    welded.source_vertex.resize(count);
    welded.locked.assign(count, 0);
    if (!surface.colors.empty()) welded.colors.resize(count, {1, 1, 1, 1});
    for (const Index v : order) {
        const Index w = copy_of[v];
        const Paint paint = painted.paint[v];
        const bool is_first_locked = paint == Paint::locked && !welded.locked[w];
        if (first_copy[w] == none || is_first_locked) welded.positions[w] = surface.positions[v];
        if (first_copy[w] == none) {
            first_copy[w] = v;
            welded.source_vertex[w] = surface.source_vertex[v];
        }
        if (paint != Paint::none && !has_color[w] && !surface.colors.empty()) {
            has_color[w] = true;
            welded.colors[w] = surface.colors[v];
        }
        if (paint == Paint::locked) welded.locked[w] = 1;
        if (paint == Paint::free) has_free[w] = true;
    }
    for (Index w = 0; w < count; ++w) {
        if (!welded.locked[w] || !has_free[w]) continue;
        const std::string& name = surface.objects[surface.parts[surface.vertex_part[first_copy[w]]].object].name;
        count_one(welded.conflicts, {welded.positions[w], welded.source_vertex[w], name});
    }
}

}

Welded weld(const Surface& surface, const PaintedVertices& painted, double tolerance) {
    Welded welded;
    welded.conflicts = {"LOCK_CONFLICT", Severity::warning, "", 0, {}};
    const auto order = file_order(surface);
    Index count = 0;
    auto copy_of = number_positions(surface, order, count);
    welded.exact_merges = order.size() - count;
    merge_by_tolerance(surface, tolerance, copy_of, count, welded);
    gather(surface, painted, order, copy_of, count, welded);
    welded.triangles = renumber(surface.triangles, copy_of);
    welded.part = surface.part;
    return welded;
}

}
