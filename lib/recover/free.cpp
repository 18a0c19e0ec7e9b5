// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/free.h"

#include <algorithm>

namespace crumple::recover {

namespace {

// Looks at edges that one attempt to clear one may take; what needs more is rare, and a node is cheaper then.
constexpr int looks_per_edge = 200;

bool is_better(const Exchange& a, const Exchange& b) {
    return a.gain != b.gain ? a.gain > b.gain : a.quality > b.quality;
}

Index face_corner(const TetComplex& complex, const Crossing& face) {
    for (int i = 0; i < 4; ++i) {
        const Index v = complex.corners(face.tet)[i];
        if (v != face.nodes[0] && v != face.nodes[1] && v != face.nodes[2]) return static_cast<Index>(i);
    }
    return 0;
}

}

bool is_blocked(const Constraints& constraints, const std::vector<Crossing>& crossings) {
    return std::any_of(crossings.begin(), crossings.end(), [&](const Crossing& c) {
        if (c.count == 3) return constraints.has_facet(c.nodes[0], c.nodes[1], c.nodes[2]);
        return c.count == 2 && constraints.has_segment(c.nodes[0], c.nodes[1]);
    });
}

bool is_blocked(const Constraints& constraints, const FacetObstacles& obstacles) {
    return std::any_of(obstacles.edges.begin(), obstacles.edges.end(),
                       [&](const PiercingEdge& e) { return constraints.has_segment(e.nodes[0], e.nodes[1]); });
}

bool Liberator::exchange_for_segment(const Goal& goal) {
    Exchange best;
    Exchange exchange;
    const auto keep_if_better = [&](bool is_possible) {
        if (is_possible && exchange.gain > 0 && (best.fresh.empty() || is_better(exchange, best))) best = exchange;
    };
    for (const Crossing& crossing : crossings_) {
        if (crossing.count == 3) {
            const int corner = static_cast<int>(face_corner(complex_, crossing));
            keep_if_better(flips_.plan_face_removal(goal, crossing.tet, corner, exchange));
        }
        for (int i = 0; i < (crossing.count == 3 ? 3 : 1); ++i) {
            const Index u = crossing.nodes[i];
            const Index v = crossing.nodes[(i + 1) % crossing.count];
            keep_if_better(flips_.plan_edge_removal(goal, crossing.tet, u, v, exchange));
        }
    }
    if (best.fresh.empty()) return false;
    flips_.apply(best);
    return true;
}

bool Liberator::clear_for_segment(const Goal& goal, int depth) {
    const std::vector<Crossing> before = crossings_;
    for (const Crossing& crossing : before) {
        for (int i = 0; i < (crossing.count == 3 ? 3 : 1); ++i) {
            flips_.set_budget(looks_per_edge);
            const std::size_t start = flips_.mark();
            if (!flips_.clear_edge(crossing.nodes[i], crossing.nodes[(i + 1) % crossing.count], depth)) continue;
            crossings_of_segment(complex_, goal.a, goal.b, crossings_);
            if (crossings_.size() < before.size()) return true;
            flips_.roll_back(start);
        }
    }
    crossings_of_segment(complex_, goal.a, goal.b, crossings_);
    return false;
}

Outcome Liberator::free_segment(Index a, Index b, int depth) {
    const Goal goal{a, b, none};
    while (true) {
        flips_.forget();
        crossings_of_segment(complex_, a, b, crossings_);
        if (crossings_.empty()) return Outcome::there;
        const Crossing& last = crossings_.back();
        if (last.count == 1) {
            node_ = last.nodes[0];
            return Outcome::through;
        }
        if (exchange_for_segment(goal)) continue;
        if (is_blocked(constraints_, crossings_)) return Outcome::blocked;
        bool has_progress = false;
        for (int level = 1; level <= depth && !has_progress && !is_out_of_budget(); ++level)
            has_progress = clear_for_segment(goal, level);
        if (!has_progress) return Outcome::stuck;
    }
}

bool Liberator::exchange_for_facet(const Goal& goal) {
    Exchange best;
    Exchange exchange;
    for (const PiercingEdge& edge : obstacles_.edges) {
        if (!flips_.plan_edge_removal(goal, edge.tet, edge.nodes[0], edge.nodes[1], exchange)) continue;
        if (exchange.gain > 0 && (best.fresh.empty() || is_better(exchange, best))) best = exchange;
    }
    if (best.fresh.empty()) return false;
    flips_.apply(best);
    return true;
}

bool Liberator::clear_for_facet(const Goal& goal, int depth) {
    const FacetObstacles before = obstacles_;
    const Triangle facet{goal.a, goal.b, goal.c};
    for (const PiercingEdge& edge : before.edges) {
        flips_.set_budget(looks_per_edge);
        const std::size_t start = flips_.mark();
        if (!flips_.clear_edge(edge.nodes[0], edge.nodes[1], depth)) continue;
        obstacles_of_facet(complex_, facet, obstacles_);
        if (obstacles_.node == none && obstacles_.edges.size() < before.edges.size()) return true;
        flips_.roll_back(start);
    }
    obstacles_of_facet(complex_, facet, obstacles_);
    return false;
}

Outcome Liberator::free_facet(const Triangle& facet, int depth) {
    const Goal goal{facet[0], facet[1], facet[2]};
    while (true) {
        flips_.forget();
        obstacles_of_facet(complex_, facet, obstacles_);
        node_ = obstacles_.node;
        if (node_ != none) return Outcome::through;
        if (obstacles_.edges.empty()) return Outcome::there;
        if (exchange_for_facet(goal)) continue;
        if (is_blocked(constraints_, obstacles_)) return Outcome::blocked;
        bool has_progress = false;
        for (int level = 1; level <= depth && !has_progress && !is_out_of_budget(); ++level)
            has_progress = clear_for_facet(goal, level);
        if (!has_progress) return Outcome::stuck;
    }
}

}
