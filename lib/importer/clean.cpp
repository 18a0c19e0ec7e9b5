// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/clean.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <string>

#include "core/counted.h"
#include "geometry/predicates.h"
#include "importer/edges.h"

namespace crumple::importer {

namespace {

bool repeats_a_vertex(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

bool has_no_area(const Welded& shell, const Triangle& t) {
    return are_collinear(shell.positions[t[0]], shell.positions[t[1]], shell.positions[t[2]]);
}

void keep_triangles(Welded& shell, const std::vector<bool>& keep) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
        if (!keep[t]) continue;
        shell.triangles[kept] = shell.triangles[t];
        shell.part[kept++] = shell.part[t];
    }
    shell.triangles.resize(kept);
    shell.part.resize(kept);
}

std::uint64_t drop_repeated_indices(Welded& shell) {
    std::vector<bool> keep(shell.triangles.size());
    for (std::size_t t = 0; t < keep.size(); ++t) keep[t] = !repeats_a_vertex(shell.triangles[t]);
    const auto dropped = static_cast<std::uint64_t>(std::count(keep.begin(), keep.end(), false));
    if (dropped > 0) keep_triangles(shell, keep);
    return dropped;
}

Place place_of(const Welded& shell, const Surface& surface, Index t) {
    const Triangle& corners = shell.triangles[t];
    const Vec3 centre = (shell.positions[corners[0]] + shell.positions[corners[1]] + shell.positions[corners[2]]) / 3.0;
    return {centre, t, surface.objects[surface.parts[shell.part[t]].object].name};
}

// Turned so that the smallest vertex comes first; the side it faces stays.
Triangle canonical(Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

// The first of equal triangles stays. Those back to back are another thing: a wall of two solids that touch.
std::uint64_t drop_duplicates(const Surface& surface, Welded& shell, std::vector<Finding>& findings) {
    std::vector<Index> order(shell.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        const Triangle left = canonical(shell.triangles[a]);
        const Triangle right = canonical(shell.triangles[b]);
        return left != right ? left < right : a < b;
    });
    std::vector<bool> keep(order.size(), true);
    Finding finding{"SHELL_DUPLICATE", Severity::info, "", 0, {}};
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (canonical(shell.triangles[order[i]]) != canonical(shell.triangles[order[i - 1]])) continue;
        keep[order[i]] = false;
        count_one(finding, place_of(shell, surface, order[i]));
    }
    if (finding.count == 0) return 0;
    keep_triangles(shell, keep);
    finding.message = counted(finding.count, "triangle is in the file twice; the second copy was",
                              "triangles are in the file twice; the second copies were") +
                      " dropped (places count before that)";
    findings.push_back(finding);
    return finding.count;
}

// The side of a triangle with collinear corners that holds the third corner: from corner `side` to the next.
int long_side(const Welded& shell, const Triangle& t) {
    int longest = 0;
    double longest_2 = -1;
    for (int side = 0; side < 3; ++side) {
        const Vec3 along = shell.positions[t[static_cast<std::size_t>((side + 1) % 3)]] -
                           shell.positions[t[static_cast<std::size_t>(side)]];
        if (dot(along, along) <= longest_2) continue;
        longest = side;
        longest_2 = dot(along, along);
    }
    return longest;
}

std::span<const HalfEdge> edge_of(const std::vector<HalfEdge>& sorted, Index a, Index b) {
    const auto before = [](const HalfEdge& edge, std::array<Index, 2> key) {
        return edge.low != key[0] ? edge.low < key[0] : edge.high < key[1];
    };
    const std::array<Index, 2> key{std::min(a, b), std::max(a, b)};
    const auto begin = std::lower_bound(sorted.begin(), sorted.end(), key, before);
    auto end = begin;
    while (end != sorted.end() && end->low == key[0] && end->high == key[1]) ++end;
    return {begin, end};
}

// One pass over the flat triangles; those near a change wait for the next pass. Returns whether anything changed.
class FlatTriangles {
public:
    explicit FlatTriangles(Welded& shell) : shell_(shell), sorted_(sorted_half_edges(shell.triangles)) {}

    bool pass() {
        touched_.assign(shell_.triangles.size(), false);
        keep_.assign(shell_.triangles.size(), true);
        bool changed = false;
        for (Index t = 0; t < shell_.triangles.size(); ++t) {
            if (!touched_[t] && has_no_area(shell_, shell_.triangles[t])) changed = treat(t) || changed;
        }
        if (changed) keep_triangles(shell_, keep_);
        return changed;
    }

private:
    bool treat(Index t) {
        const Triangle corners = shell_.triangles[t];
        const auto side = static_cast<std::size_t>(long_side(shell_, corners));
        const Index from = corners[side];
        const Index to = corners[(side + 1) % 3];
        const Index middle = corners[(side + 2) % 3];
        const auto edge = edge_of(sorted_, from, to);
        if (edge.size() == 1) return drop(t);
        if (edge.size() != 2 || edge[0].ascends == edge[1].ascends) return false;
        const HalfEdge& other = edge[0].triangle == t ? edge[1] : edge[0];
        if (touched_[other.triangle]) return false;
        const Index apex = shell_.triangles[other.triangle][(other.side + 2) % 3];
        if (apex == middle) return drop(t) && drop(other.triangle);
        if (!edge_of(sorted_, apex, middle).empty()) return false;
        shell_.triangles[t] = {to, middle, apex};
        shell_.triangles[other.triangle] = {middle, from, apex};
        shell_.part[t] = shell_.part[other.triangle];
        touch(t);
        touch(other.triangle);
        return true;
    }
    bool drop(Index t) {
        keep_[t] = false;
        touch(t);
        return true;
    }
    // The sorted edges no longer hold for the triangle and its neighbours.
    void touch(Index t) {
        touched_[t] = true;
        for (const Index a : shell_.triangles[t]) {
            for (const Index b : shell_.triangles[t]) {
                if (a >= b) continue;
                for (const HalfEdge& edge : edge_of(sorted_, a, b)) touched_[edge.triangle] = true;
            }
        }
    }

    Welded& shell_;
    std::vector<HalfEdge> sorted_;
    std::vector<bool> touched_;
    std::vector<bool> keep_;
};

Finding find_flat(const Surface& surface, const Welded& shell) {
    Finding finding{"SHELL_DEGENERATE", Severity::info, "", 0, {}};
    for (Index t = 0; t < shell.triangles.size(); ++t) {
        if (has_no_area(shell, shell.triangles[t])) count_one(finding, place_of(shell, surface, t));
    }
    return finding;
}

std::uint64_t flatten_out(const Surface& surface, Welded& shell, std::vector<Finding>& findings) {
    Finding finding = find_flat(surface, shell);
    if (finding.count == 0) return 0;
    // Needles side by side need a pass each; what is left after this many has a problem of its own.
    constexpr int max_passes = 32;
    for (int pass = 0; pass < max_passes && FlatTriangles(shell).pass(); ++pass) {
    }
    const std::uint64_t left = find_flat(surface, shell).count;
    finding.severity = left > 0 ? Severity::warning : Severity::info;
    finding.message = counted(finding.count, "triangle has", "triangles have") + " no area; " +
                      counted(finding.count - std::min(left, finding.count), "was", "were") +
                      " merged into neighbours (places count before that)";
    findings.push_back(finding);
    return finding.count;
}

void drop_unused_vertices(Welded& shell, Finding& unused_locks) {
    std::vector<Index> number(shell.positions.size(), none);
    for (const Triangle& t : shell.triangles) {
        for (const Index v : t) number[v] = 0;
    }
    Index kept = 0;
    for (Index v = 0; v < number.size(); ++v) {
        if (number[v] == none) {
            if (shell.locked[v]) count_one(unused_locks, {shell.positions[v], shell.source_vertex[v], ""});
            continue;
        }
        number[v] = kept;
        shell.positions[kept] = shell.positions[v];
        if (!shell.colors.empty()) shell.colors[kept] = shell.colors[v];
        shell.locked[kept] = shell.locked[v];
        shell.source_vertex[kept] = shell.source_vertex[v];
        ++kept;
    }
    shell.positions.resize(kept);
    if (!shell.colors.empty()) shell.colors.resize(kept);
    shell.locked.resize(kept);
    shell.source_vertex.resize(kept);
    for (Triangle& t : shell.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
}

}

Cleaned clean(const Surface& surface, Welded& welded) {
    Cleaned result;
    result.repeated_index = drop_repeated_indices(welded);
    result.duplicates = drop_duplicates(surface, welded, result.findings);
    result.zero_area = flatten_out(surface, welded, result.findings);
    Finding unused_locks{"LOCK_UNUSED", Severity::warning, "", 0, {}};
    drop_unused_vertices(welded, unused_locks);
    result.unused_locks = unused_locks.count;
    if (unused_locks.count > 0) {
        unused_locks.message = counted(unused_locks.count, "locked vertex belongs", "locked vertices belong") +
                               " to no triangle and were dropped";
        result.findings.push_back(unused_locks);
    }
    return result;
}

}
