// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/components.h"

#include <algorithm>
#include <string>

#include "core/counted.h"
#include "core/disjoint_sets.h"
#include "geometry/measures.h"
#include "importer/edges.h"

namespace crumple::importer {

namespace {

Index object_of(const Surface& surface, const Welded& shell, Index t) { return surface.parts[shell.part[t]].object; }

// Closed: each edge has an even number of the object's triangles. Their winding is not yet to be trusted.
std::vector<bool> closed_objects(const Surface& surface, const Welded& shell, const std::vector<HalfEdge>& half_edges) {
    std::vector<bool> closed(surface.objects.size(), true);
    std::vector<Index> on_edge;
    for_each_edge(half_edges, [&](std::span<const HalfEdge> edge) {
        on_edge.clear();
        for (const HalfEdge& side : edge) on_edge.push_back(object_of(surface, shell, side.triangle));
        std::sort(on_edge.begin(), on_edge.end());
        for (std::size_t begin = 0; begin < on_edge.size();) {
            const auto end =
                std::upper_bound(on_edge.begin() + static_cast<std::ptrdiff_t>(begin), on_edge.end(), on_edge[begin]);
            const auto count = static_cast<std::size_t>(end - on_edge.begin()) - begin;
            if (count % 2 != 0) closed[on_edge[begin]] = false;
            begin += count;
        }
    });
    return closed;
}

// Objects that are one surface: each closed one for itself, all open ones together (as the number of objects).
std::vector<Index> pools_of(const Surface& surface, const std::vector<bool>& closed) {
    std::vector<Index> pool(surface.objects.size());
    for (Index o = 0; o < pool.size(); ++o) pool[o] = closed[o] ? o : static_cast<Index>(pool.size());
    return pool;
}

// Unites triangles that share a vertex within a pool, and numbers the sets by their first triangle.
std::vector<Index> connect(const Surface& surface, const Welded& shell, const std::vector<Index>& pool) {
    struct Corner {
        Index vertex;
        Index pool;
        Index triangle;
    };
    std::vector<Corner> corners;
    for (Index t = 0; t < shell.triangles.size(); ++t) {
        for (const Index v : shell.triangles[t]) corners.push_back({v, pool[object_of(surface, shell, t)], t});
    }
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
        if (a.vertex != b.vertex) return a.vertex < b.vertex;
        return a.pool != b.pool ? a.pool < b.pool : a.triangle < b.triangle;
    });
    DisjointSets sets(shell.triangles.size());
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const bool meet = corners[i].vertex == corners[i - 1].vertex && corners[i].pool == corners[i - 1].pool;
        if (meet) sets.unite(corners[i].triangle, corners[i - 1].triangle);
    }
    std::vector<Index> of_triangle(shell.triangles.size());
    Index count = 0;
    for (Index t = 0; t < of_triangle.size(); ++t) {
        const Index root = sets.find(t);
        of_triangle[t] = root == t ? count++ : of_triangle[root];
    }
    return of_triangle;
}

struct Neighbour {
    Index triangle;
    bool agrees;  // passes the shared edge the other way
};

// Across edges that exactly two triangles of one component share. Begin of each triangle's list in `start`.
struct Neighbours {
    std::vector<Index> start;
    std::vector<Neighbour> list;
};

Neighbours find_neighbours(const std::vector<HalfEdge>& half_edges, const std::vector<Index>& of_triangle) {
    std::vector<std::array<Index, 2>> pairs;
    std::vector<bool> agrees;
    for_each_component_edge(half_edges, of_triangle, [&](Index, std::span<const HalfEdge> edge) {
        if (edge.size() != 2 || edge[0].triangle == edge[1].triangle) return;
        pairs.push_back({edge[0].triangle, edge[1].triangle});
        agrees.push_back(edge[0].ascends != edge[1].ascends);
    });
    Neighbours result;
    result.start.assign(of_triangle.size() + 1, 0);
    for (const auto& [a, b] : pairs) {
        ++result.start[a + 1];
        ++result.start[b + 1];
    }
    std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
    result.list.resize(result.start.back());
    std::vector<Index> next(result.start.begin(), result.start.end() - 1);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        result.list[next[pairs[i][0]]++] = {pairs[i][1], agrees[i]};
        result.list[next[pairs[i][1]]++] = {pairs[i][0], agrees[i]};
    }
    return result;
}

// Walks the patch of `seed` over two-triangle edges and decides for each triangle whether it has to turn to agree with
// the seed. Returns the patch; conflicted says that it cannot be done (a Moebius band).
std::vector<Index> walk_patch(const Neighbours& neighbours, Index seed, std::vector<signed char>& turn,
                              bool& conflicted) {
    std::vector<Index> patch{seed};
    turn[seed] = 0;
    for (std::size_t i = 0; i < patch.size(); ++i) {
        const Index t = patch[i];
        for (Index n = neighbours.start[t]; n < neighbours.start[t + 1]; ++n) {
            const auto wanted = static_cast<signed char>(neighbours.list[n].agrees ? turn[t] : 1 - turn[t]);
            signed char& other = turn[neighbours.list[n].triangle];
            if (other < 0) {
                other = wanted;
                patch.push_back(neighbours.list[n].triangle);
            } else if (other != wanted) {
                conflicted = true;
            }
        }
    }
    return patch;
}

Place place_of(const Welded& shell, const Surface& surface, Index t, Vec3 position) {
    return {position, t, surface.objects[object_of(surface, shell, t)].name};
}

Vec3 centre_of(const Welded& shell, const Triangle& t) {
    return (shell.positions[t[0]] + shell.positions[t[1]] + shell.positions[t[2]]) / 3.0;
}

// The fewer triangles of each patch turn. A patch that cannot agree stays as it is.
void orient(const Surface& surface, const std::vector<HalfEdge>& half_edges, Welded& shell, Components& result) {
    const Neighbours neighbours = find_neighbours(half_edges, result.of_triangle);
    Finding repaired{"SHELL_INCONSISTENT", Severity::warning, "", 0, {}};
    Finding stuck{"SHELL_NOT_ORIENTABLE", Severity::warning, "", 0, {}};
    std::vector<signed char> turn(shell.triangles.size(), -1);
    for (Index seed = 0; seed < shell.triangles.size(); ++seed) {
        if (turn[seed] >= 0) continue;
        bool conflicted = false;
        const auto patch = walk_patch(neighbours, seed, turn, conflicted);
        if (conflicted) {
            stuck.count += patch.size();
            if (wants_place(stuck))
                stuck.places.push_back(place_of(shell, surface, seed, centre_of(shell, shell.triangles[seed])));
            continue;
        }
        const auto turned = std::count_if(patch.begin(), patch.end(), [&](Index t) { return turn[t] == 1; });
        const signed char fewer = static_cast<std::size_t>(2 * turned) <= patch.size() ? 1 : 0;
        for (const Index t : patch) {
            if (turn[t] != fewer) continue;
            std::swap(shell.triangles[t][1], shell.triangles[t][2]);
            count_one(repaired, place_of(shell, surface, t, centre_of(shell, shell.triangles[t])));
        }
    }
    result.flipped = repaired.count;
    if (repaired.count > 0) {
        repaired.message = repaired.count == 1
                               ? "1 triangle faced the other way than its neighbours and was turned"
                               : std::to_string(repaired.count) +
                                     " triangles faced the other way than their neighbours and were turned";
        result.findings.push_back(repaired);
    }
    if (stuck.count > 0) {
        stuck.message = "patches of " + counted(stuck.count, "triangle", "triangles") +
                        " in all have no inside and outside (like a "
                        "Moebius band); cut or rebuild them";
        result.findings.push_back(stuck);
    }
}

void judge_edges(const Surface& surface, const Welded& shell, Components& result) {
    Finding open{"SHELL_OPEN", Severity::warning, "", 0, {}};
    Finding many{"SHELL_NON_MANIFOLD", Severity::warning, "", 0, {}};
    const auto add = [&](Finding& finding, const HalfEdge& side) {
        const Vec3 middle = (shell.positions[side.low] + shell.positions[side.high]) / 2.0;
        count_one(finding, place_of(shell, surface, side.triangle, middle));
    };
    const auto half_edges = sorted_half_edges(shell.triangles);
    for_each_component_edge(half_edges, result.of_triangle, [&](Index component, std::span<const HalfEdge> edge) {
        const auto ascending = static_cast<std::size_t>(
            std::count_if(edge.begin(), edge.end(), [](const HalfEdge& side) { return side.ascends; }));
        if (2 * ascending != edge.size()) result.facts[component].is_closed = false;
        if (edge.size() == 1) add(open, edge[0]);
        if (edge.size() > 2) add(many, edge[0]);
    });
    result.open_edges = open.count;
    result.non_manifold_edges = many.count;
    if (open.count > 0) {
        open.message = counted(open.count, "edge has", "edges have") +
                       " a triangle on one side only: the shell is not closed, "
                       "inside and outside are a guess there; close the holes";
        result.findings.push_back(open);
    }
    if (many.count > 0) {
        many.message = counted(many.count, "edge has", "edges have") +
                       " more than two triangles; separate what touches there, or "
                       "remove inner walls";
        result.findings.push_back(many);
    }
}

// Measured from a corner of each component, so that a far place costs no digits.
void measure(const Welded& shell, Components& result) {
    std::vector<Index> origin(result.facts.size(), none);
    for (Index t = 0; t < shell.triangles.size(); ++t) {
        ComponentFacts& facts = result.facts[result.of_triangle[t]];
        Index& o = origin[result.of_triangle[t]];
        const Triangle& corners = shell.triangles[t];
        if (o == none) o = corners[0];
        ++facts.triangle_count;
        facts.signed_volume += signed_volume(shell.positions[o], shell.positions[corners[0]],
                                             shell.positions[corners[1]], shell.positions[corners[2]]);
    }
}

}

Components split_components(const Surface& surface, Welded& shell) {
    const auto half_edges = sorted_half_edges(shell.triangles);
    Components result;
    result.of_triangle = connect(surface, shell, pools_of(surface, closed_objects(surface, shell, half_edges)));
    for (Index t = 0; t < shell.triangles.size(); ++t) {
        if (result.of_triangle[t] < result.facts.size()) continue;
        result.facts.push_back({object_of(surface, shell, t), shell.part[t], 0, 0, true});
    }
    orient(surface, half_edges, shell, result);
    judge_edges(surface, shell, result);
    measure(shell, result);
    return result;
}

}
