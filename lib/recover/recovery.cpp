// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/recovery.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/measures.h"
#include "geometry/predicates.h"
#include "recover/deviation.h"
#include "recover/insert_node.h"

namespace crumple::recover {

namespace {

// Rounds of splitting, freeing and taking back use the same allowance again, but not for ever.
constexpr std::size_t tries_per_split = 10;

// What is freed may push aside what was negligible or half free before, so all are looked at again, but two that cannot
// both be free would take turns for ever.
constexpr int max_passes = 4;

// Of the diagonal: what an artist's eye and a solver's shape both miss.
constexpr double negligible_of_diagonal = 1e-3;

std::vector<Index> stars_of(const TetComplex& complex, std::initializer_list<Index> nodes) {
    std::vector<Index> all;
    std::vector<Index> star;
    for (const Index v : nodes) {
        complex.star_of(v, star);
        all.insert(all.end(), star.begin(), star.end());
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}

Recovery::Recovery(TetComplex& complex, Constraints& constraints, const Params& params, const Context& context)
    : complex_(complex),
      constraints_(constraints),
      params_(params),
      context_(context),
      liberator_(complex, constraints),
      node_count_(static_cast<Index>(complex.positions().size())),
      largest_loss_(bounding_box(complex.positions()).diagonal() * negligible_of_diagonal),
      max_splits_(0) {
    // A handful for shells of few vertices, where a tenth is none.
    std::size_t nodes = 0;
    std::vector<std::uint8_t> is_on_shell(node_count_, 0);
    for (const Edge& e : constraints.segments()) {
        for (const Index v : e) nodes += !std::exchange(is_on_shell[v], 1);
    }
    if (params.max_steiner > 0)
        max_splits_ = static_cast<std::size_t>(params.max_steiner * static_cast<double>(nodes)) + 4;
    liberator_.set_budget(std::uint64_t{params.budget} *
                          (constraints.segments().size() + constraints.facets().size()));
}

std::vector<Edge> Recovery::missing_segments() const {
    std::vector<Edge> missing;
    for (const Edge& e : constraints_.segments()) {
        if (!has_edge(e[0], e[1])) missing.push_back(e);
    }
    return missing;
}

std::vector<Triangle> Recovery::missing_facets() const {
    std::vector<Triangle> missing;
    for (const Triangle& t : constraints_.facets()) {
        if (!has_face(t)) missing.push_back(t);
    }
    return missing;
}

bool Recovery::matters(const Edge& segment) const {
    const std::vector<Index>& apexes = constraints_.apexes(segment);
    if (is_part(segment) || is_part(apexes)) return true;
    if (params_.mode == Mode::always) return !is_covered(complex_, segment, apexes);
    const double loss = std::min(largest_loss_, params_.negligible * length_of(segment[0], segment[1]));
    return deviation_of_segment(complex_, segment, apexes) > loss ||
           std::any_of(apexes.begin(), apexes.end(),
                       [&](Index apex) { return matters(sorted_triangle(segment[0], segment[1], apex)); });
}

bool Recovery::matters(const Triangle& facet) const {
    if (is_part(facet)) return true;
    if (params_.mode == Mode::always) return !is_covered(complex_, facet);
    return deviation_of_facet(complex_, facet) > std::min(largest_loss_, params_.negligible * size_of(facet));
}

void Recovery::add_parts(const Split& split) {
    const auto add = [&](Index p, Index q, Index r) {
        todo_facets_.push_back(sorted_triangle(p, q, r));
        todo_segments_.push_back(sorted_edge(p, q));
        todo_segments_.push_back(sorted_edge(q, r));
    };
    if (split.c != none) {
        add(split.a, split.node, split.b);
        add(split.b, split.node, split.c);
        add(split.c, split.node, split.a);
    }
    for (const Index apex : split.apexes) {
        add(split.a, split.node, apex);
        add(split.b, split.node, apex);
    }
}

// Short ones first: they are the least in the way of others.
bool Recovery::free_segments(std::uint32_t depth) {
    std::vector<Edge> todo = std::exchange(todo_segments_, {});
    std::stable_sort(todo.begin(), todo.end(),
                     [&](const Edge& a, const Edge& b) { return length_of(a[0], a[1]) < length_of(b[0], b[1]); });
    std::vector<Edge> stuck;
    for (const Edge& e : todo) {
        context_.stop_if_cancelled();
        if (!constraints_.has_segment(e[0], e[1]) || has_edge(e[0], e[1]) || !matters(e)) continue;
        const Outcome outcome =
            tired_segments_.contains(e) ? Outcome::stuck : liberator_.free_segment(e[0], e[1], static_cast<int>(depth));
        if (outcome == Outcome::blocked) blocked_segments_.insert(e);
        if (outcome == Outcome::through) add_parts(split_segment(constraints_, e[0], e[1], liberator_.node()));
        if (outcome != Outcome::stuck) continue;
        stuck.push_back(e);
        if (depth == params_.depth) tired_segments_.insert(e);
    }
    todo_segments_.insert(todo_segments_.begin(), stuck.begin(), stuck.end());
    return !todo_segments_.empty();
}

bool Recovery::free_facets(std::uint32_t depth) {
    std::vector<Triangle> todo = std::exchange(todo_facets_, {});
    std::stable_sort(todo.begin(), todo.end(),
                     [&](const Triangle& a, const Triangle& b) { return size_of(a) < size_of(b); });
    std::vector<Triangle> left;
    bool is_stuck = false;
    for (const Triangle& t : todo) {
        context_.stop_if_cancelled();
        if (!constraints_.has_facet(t[0], t[1], t[2]) || has_face(t)) continue;
        if (!has_edges(t)) {
            left.push_back(t);
            continue;
        }
        if (!matters(t)) continue;
        const Outcome outcome =
            tired_facets_.contains(t) ? Outcome::stuck : liberator_.free_facet(t, static_cast<int>(depth));
        if (outcome == Outcome::blocked) blocked_facets_.insert(t);
        if (outcome == Outcome::through) add_parts(split_facet(constraints_, t, liberator_.node()));
        if (outcome != Outcome::stuck) continue;
        is_stuck = true;
        left.push_back(t);
        if (depth == params_.depth) tired_facets_.insert(t);
    }
    is_stuck |= !todo_facets_.empty();
    todo_facets_.insert(todo_facets_.begin(), left.begin(), left.end());
    return is_stuck;
}

bool Recovery::may_split() const {
    return splits_.size() < max_splits_ && splits_tried_ < tries_per_split * max_splits_ && !is_out_of_budget();
}

bool Recovery::split_at_crossing(const Edge& segment) {
    const Vec3 a = complex_.position(segment[0]);
    const Vec3 b = complex_.position(segment[1]);
    // The crossing next to the middle.
    const Crossing* best = nullptr;
    double best_share = 0;
    for (const Crossing& crossing : liberator_.crossings()) {
        const double share = crossing_share(complex_, segment, crossing);
        if (!(share > 0 && share < 1)) continue;
        if (best == nullptr || std::fabs(share - 0.5) < std::fabs(best_share - 0.5)) {
            best = &crossing;
            best_share = share;
        }
    }
    if (best == nullptr) return false;
    const Vec3 place = round_to_float(a + (b - a) * best_share);
    if (place == a || place == b) return false;
    const std::vector<Index> candidates = best->count == 3
                                              ? stars_of(complex_, {best->nodes[0], best->nodes[1], best->nodes[2]})
                                              : stars_of(complex_, {best->nodes[0], best->nodes[1]});
    const std::vector<Index> holders = holders_of(complex_, candidates, place);
    if (holders.empty()) return false;
    const Index node = insert_node(complex_, constraints_, place, holders);
    if (node == none) return false;
    splits_.push_back(split_segment(constraints_, segment[0], segment[1], node));
    add_parts(splits_.back());
    ++splits_tried_;
    return true;
}

bool Recovery::split_stuck_segments() {
    bool has_split = false;
    const std::vector<Edge> stuck = todo_segments_;
    for (const Edge& e : stuck) {
        if (!may_split()) break;
        if (!constraints_.has_segment(e[0], e[1]) || has_edge(e[0], e[1]) || !matters(e)) continue;
        const Outcome outcome = liberator_.free_segment(e[0], e[1], 0);
        if (outcome == Outcome::through) add_parts(split_segment(constraints_, e[0], e[1], liberator_.node()));
        has_split |= outcome == Outcome::stuck && split_at_crossing(e);
    }
    return has_split;
}

bool Recovery::split_at_obstacle(const Triangle& facet) {
    const Vec3 a = complex_.position(facet[0]);
    const Vec3 b = complex_.position(facet[1]);
    const Vec3 c = complex_.position(facet[2]);
    const Vec3 middle = (a + b + c) / 3;
    const PiercingEdge* best = nullptr;
    Vec3 best_place;
    for (const PiercingEdge& edge : liberator_.obstacles().edges) {
        if (constraints_.has_segment(edge.nodes[0], edge.nodes[1])) continue;
        const Vec3 place = piercing_place(complex_, facet, edge.nodes);
        if (best == nullptr || length(place - middle) < length(best_place - middle)) {
            best = &edge;
            best_place = place;
        }
    }
    if (best == nullptr) return false;
    const Vec3 place = round_to_float(best_place);
    const std::vector<Index> holders =
        holders_of(complex_, stars_of(complex_, {best->nodes[0], best->nodes[1]}), place);
    if (holders.empty()) return false;
    const Index node = insert_node(complex_, constraints_, place, holders);
    if (node == none) return false;
    splits_.push_back(split_facet(constraints_, facet, node));
    add_parts(splits_.back());
    ++splits_tried_;
    return true;
}

bool Recovery::split_stuck_facets() {
    bool has_split = false;
    const std::vector<Triangle> stuck = todo_facets_;
    for (const Triangle& t : stuck) {
        if (!may_split()) break;
        if (!constraints_.has_facet(t[0], t[1], t[2]) || has_face(t) || !has_edges(t) || !matters(t)) continue;
        const Outcome outcome = liberator_.free_facet(t, 0);
        if (outcome == Outcome::through) add_parts(split_facet(constraints_, t, liberator_.node()));
        has_split |= outcome == Outcome::stuck && split_at_obstacle(t);
    }
    return has_split;
}

bool Recovery::undo_splits() {
    const std::size_t before = splits_.size();
    std::vector<Split> staying;
    while (!splits_.empty()) {
        if (!undo_split(complex_, constraints_, splits_.back())) staying.push_back(splits_.back());
        splits_.pop_back();
    }
    splits_.assign(staying.rbegin(), staying.rend());
    return splits_.size() < before;
}

bool Recovery::free_all() {
    bool is_stuck = true;
    for (std::uint32_t depth = 0; depth <= params_.depth && is_stuck; ++depth) is_stuck = free_segments(depth);
    const bool segments_stuck = is_stuck;
    is_stuck = true;
    for (std::uint32_t depth = 0; depth <= params_.depth && is_stuck; ++depth) is_stuck = free_facets(depth);
    return segments_stuck || is_stuck;
}

void Recovery::start_pass() {
    todo_segments_ = missing_segments();
    todo_facets_ = missing_facets();
    std::erase_if(todo_segments_, [&](const Edge& e) { return blocked_segments_.contains(e); });
    std::erase_if(todo_facets_, [&](const Triangle& t) { return blocked_facets_.contains(t); });
    tired_segments_.clear();
    tired_facets_.clear();
}

void Recovery::run() {
    for (int pass = 0; pass < max_passes; ++pass) {
        context_.tell_progress("edges and triangles", static_cast<double>(pass) / max_passes);
        const std::uint64_t before = exchanges() + splits_tried_;
        start_pass();
        bool goes_on = true;
        while (goes_on) {
            const bool is_stuck = free_all();
            // Parts of the last round's splits are there now, as far as they ever will be.
            goes_on = undo_splits();
            if (is_stuck) goes_on |= split_stuck_segments() || split_stuck_facets();
        }
        if (exchanges() + splits_tried_ == before) break;
    }
    drop_splits();
}

// What never came back whole with its nodes is better off without them.
void Recovery::drop_splits() {
    std::vector<Split> staying;
    while (!splits_.empty()) {
        if (!drop_split(complex_, constraints_, splits_.back())) staying.push_back(splits_.back());
        splits_.pop_back();
    }
    splits_.assign(staying.rbegin(), staying.rend());
}

Missing<Edge> Recovery::judge_segments() const {
    Missing<Edge> missing;
    std::vector<Crossing> crossings;
    for (const Edge& e : missing_segments()) {
        crossings_of_segment(complex_, e[0], e[1], crossings);
        if (!matters(e)) {
            missing.negligible.push_back(e);
        } else if (is_blocked(constraints_, crossings)) {
            missing.blocked.push_back(e);
        } else {
            missing.stuck.push_back(e);
        }
    }
    return missing;
}

Missing<Triangle> Recovery::judge_facets(const Missing<Edge>& segments) const {
    const auto has_edge_of = [](const std::vector<Edge>& edges, const Triangle& t) {
        const auto has = [&](Index a, Index b) {
            return std::binary_search(edges.begin(), edges.end(), sorted_edge(a, b));
        };
        return has(t[0], t[1]) || has(t[1], t[2]) || has(t[2], t[0]);
    };
    Missing<Triangle> missing;
    FacetObstacles obstacles;
    for (const Triangle& t : missing_facets()) {
        obstacles_of_any_facet(complex_, t, obstacles);
        if (is_blocked(constraints_, obstacles) || has_edge_of(segments.blocked, t)) {
            missing.blocked.push_back(t);
        } else if (has_edge_of(segments.stuck, t) || matters(t)) {
            missing.stuck.push_back(t);
        } else {
            missing.negligible.push_back(t);
        }
    }
    return missing;
}

}
