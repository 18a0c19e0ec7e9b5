// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/flips.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/measures.h"
#include "geometry/predicates.h"

namespace crumple::recover {

namespace {

// Larger rings cost the cube of their size and hardly ever have a positive triangulation.
constexpr std::size_t longest_ring = 24;

// A triangulation costs the cube of the ring: that of six counts as one look more.
constexpr int ring_of_one_look = 216;

bool shares_end(const Goal& goal, Index v) { return v == goal.a || v == goal.b || v == goal.c; }

}

int face_in_way(const TetComplex& complex, const Goal& goal, Index p, Index q, Index r) {
    if (goal.a == none || goal.is_facet() || shares_end(goal, p) || shares_end(goal, q) || shares_end(goal, r))
        return 0;
    return pierces(complex.position(goal.a), complex.position(goal.b), complex.position(p), complex.position(q),
                   complex.position(r));
}

int edge_in_way(const TetComplex& complex, const Goal& goal, Index p, Index q) {
    if (goal.a == none || shares_end(goal, p) || shares_end(goal, q)) return 0;
    const Vec3 a = complex.position(goal.a);
    const Vec3 b = complex.position(goal.b);
    if (!goal.is_facet()) return segments_cross(a, b, complex.position(p), complex.position(q));
    return pierces(complex.position(p), complex.position(q), a, b, complex.position(goal.c));
}

double quality_of(const TetComplex& complex, const Tet& tet) {
    const Vec3 a = complex.position(tet[0]);
    const Vec3 b = complex.position(tet[1]) - a;
    const Vec3 c = complex.position(tet[2]) - a;
    const Vec3 d = complex.position(tet[3]) - a;
    const double squares =
        dot(b, b) + dot(c, c) + dot(d, d) + dot(c - b, c - b) + dot(d - b, d - b) + dot(d - c, d - c);
    const double mean = squares / 6;
    return dot(b, cross(c, d)) * 1.4142135623730951 / (mean * std::sqrt(mean));
}

int Flips::obstacles_at_edge(const Goal& goal, Index u, Index v) const {
    int obstacles = edge_in_way(complex_, goal, u, v);
    for (const Index p : ring_.link) obstacles += face_in_way(complex_, goal, u, v, p);
    return obstacles;
}

void Flips::fill_cell(const Goal& goal, Index u, Index v, int first, int last) {
    Cell best;
    const auto at = [&](Index node) { return complex_.position(node); };
    for (int middle = first + 1; middle < last; ++middle) {
        const Cell& left = cell(first, middle);
        const Cell& right = cell(middle, last);
        if (!left.is_possible || !right.is_possible) continue;
        const int below = left.cost + right.cost;
        if (best.is_possible && below > best.cost) continue;
        const Index p = ring_.link[first];
        const Index q = ring_.link[middle];
        const Index r = ring_.link[last];
        if (orient3d(at(p), at(q), at(r), at(v)) <= 0 || orient3d(at(p), at(q), at(r), at(u)) >= 0) continue;
        const int cost = below + face_in_way(complex_, goal, p, q, r);
        const double quality = std::min(
            {left.quality, right.quality, quality_of(complex_, {p, q, r, v}), quality_of(complex_, {p, r, q, u})});
        if (best.is_possible && (cost > best.cost || (cost == best.cost && quality <= best.quality))) continue;
        best = {cost, quality, middle, true};
    }
    const bool is_rim = first == 0 && last + 1 == static_cast<int>(ring_.link.size());
    if (best.is_possible && !is_rim) {
        const Index p = ring_.link[first];
        const Index r = ring_.link[last];
        best.cost += edge_in_way(complex_, goal, p, r) + face_in_way(complex_, goal, p, r, u) +
                     face_in_way(complex_, goal, p, r, v);
    }
    cell(first, last) = best;
}

void Flips::fill_table(const Goal& goal, Index u, Index v) {
    const int n = static_cast<int>(ring_.link.size());
    table_.assign(static_cast<std::size_t>(n) * n, {});
    for (int i = 0; i + 1 < n; ++i) cell(i, i + 1) = {0, 2, -1, true};
    for (int span = 2; span < n; ++span) {
        for (int first = 0; first + span < n; ++first) fill_cell(goal, u, v, first, first + span);
    }
}

void Flips::read_table(Index u, Index v, int first, int last, std::vector<Tet>& fresh) const {
    const int middle = cell(first, last).middle;
    if (middle < 0) return;
    const Index p = ring_.link[first];
    const Index q = ring_.link[middle];
    const Index r = ring_.link[last];
    fresh.push_back({p, q, r, v});
    fresh.push_back({p, r, q, u});
    read_table(u, v, first, middle, fresh);
    read_table(u, v, middle, last, fresh);
}

bool Flips::plan_edge_removal(const Goal& goal, Index tet, Index u, Index v, Exchange& exchange) {
    if (constraints_.has_segment(u, v)) return false;
    complex_.ring_of(tet, u, v, ring_);
    const std::size_t n = ring_.link.size();
    if (n < 3 || n > longest_ring) return false;
    // On the surface an edge may go only where its two faces are coplanar: the surface is the convex hull.
    if (!ring_.is_closed && orient3d(complex_.position(u), complex_.position(v), complex_.position(ring_.link.front()),
                                     complex_.position(ring_.link.back())) != 0) {
        return false;
    }
    fill_table(goal, u, v);
    const Cell& whole = cell(0, static_cast<int>(n) - 1);
    if (!whole.is_possible) return false;
    exchange.old = ring_.tets;
    exchange.fresh.clear();
    read_table(u, v, 0, static_cast<int>(n) - 1, exchange.fresh);
    exchange.gain = obstacles_at_edge(goal, u, v) - whole.cost;
    if (!ring_.is_closed) exchange.gain -= edge_in_way(complex_, goal, ring_.link.front(), ring_.link.back());
    exchange.quality = whole.quality;
    return true;
}

bool Flips::plan_face_removal(const Goal& goal, Index tet, int corner, Exchange& exchange) {
    const Index other = complex_.neighbour(tet, corner);
    if (other == none) return false;
    const Tet& corners = complex_.corners(tet);
    const auto& face = tet_face_corners[corner];
    const Index u = corners[face[0]];
    const Index v = corners[face[1]];
    const Index w = corners[face[2]];
    if (constraints_.has_facet(u, v, w)) return false;
    const Index p = corners[corner];
    const Index q = complex_.corners(other)[complex_.face_towards(other, tet)];
    // (u, v, w) is counter-clockwise seen from q.
    exchange.fresh = {{u, v, p, q}, {v, w, p, q}, {w, u, p, q}};
    exchange.quality = 2;
    for (const Tet& t : exchange.fresh) {
        if (orient3d(complex_.position(t[0]), complex_.position(t[1]), complex_.position(t[2]),
                     complex_.position(t[3])) <= 0) {
            return false;
        }
        exchange.quality = std::min(exchange.quality, quality_of(complex_, t));
    }
    exchange.old = {tet, other};
    exchange.gain = face_in_way(complex_, goal, u, v, w) - edge_in_way(complex_, goal, p, q);
    for (const Index x : {u, v, w}) exchange.gain -= face_in_way(complex_, goal, x, p, q);
    return true;
}

void Flips::apply(const Exchange& exchange) {
    Entry entry;
    for (const Index t : exchange.old) entry.old.push_back(complex_.corners(t));
    entry.fresh = exchange.fresh;
    complex_.replace(exchange.old, exchange.fresh);
    journal_.push_back(std::move(entry));
    ++count_;
}

Index Flips::slot_of(const Tet& tet) const {
    std::vector<Index> star;
    complex_.star_of(tet[0], star);
    for (const Index t : star) {
        if (complex_.corner_of(t, tet[1]) >= 0 && complex_.corner_of(t, tet[2]) >= 0 &&
            complex_.corner_of(t, tet[3]) >= 0) {
            return t;
        }
    }
    CRUMPLE_CHECK(false, "what an exchange put in is there until it is undone");
    return none;
}

void Flips::roll_back(std::size_t mark) {
    while (journal_.size() > mark) {
        const Entry& entry = journal_.back();
        std::vector<Index> slots;
        for (const Tet& tet : entry.fresh) slots.push_back(slot_of(tet));
        complex_.replace(slots, entry.old);
        journal_.pop_back();
        --count_;
    }
}

bool Flips::clear_edge(Index u, Index v, int depth) {
    if (constraints_.has_segment(u, v) || looks_left_ <= 0) return false;
    const Index tet = complex_.find_edge(u, v);
    if (tet == none) return true;
    complex_.ring_of(tet, u, v, ring_);
    const auto n = static_cast<int>(std::min(ring_.link.size(), longest_ring));
    const int looks = 1 + n * n * n / ring_of_one_look;
    looks_left_ -= looks;
    looks_ += static_cast<std::uint64_t>(looks);
    Exchange exchange;
    if (plan_edge_removal({}, tet, u, v, exchange)) {
        apply(exchange);
        return true;
    }
    if (depth == 0) return false;
    complex_.ring_of(tet, u, v, ring_);
    const std::vector<Index> link = ring_.link;
    for (const Index p : link) {
        for (const Index end : {u, v}) {
            const std::size_t start = mark();
            // A ring without p is shorter, and other triangulations of it may be positive.
            if (clear_edge(end, p, depth - 1) && clear_edge(u, v, depth - 1)) return true;
            roll_back(start);
        }
    }
    return false;
}

}
