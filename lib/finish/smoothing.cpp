// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/smoothing.h"

#include <algorithm>
#include <cmath>

namespace crumple::finish {

namespace {

constexpr int max_steps = 6;
constexpr int max_halvings = 4;
// Functions this near to the minimum pull on the node together; fewer, and it zigzags between two of them.
constexpr double active_share = 0.03;
// A step that gains less than this share ends the search.
constexpr double worthwhile_share = 0.01;

struct Term {
    double value;
    Vec3 gradient;
};

void collect_terms(Vec3 node, const std::vector<OppositeFace>& faces, std::vector<Term>& terms) {
    terms.clear();
    for (const OppositeFace& face : faces) {
        const ShapeTerms of_tet = shape_terms(node, face[0], face[1], face[2]);
        for (int i = 0; i < 7; ++i) terms.push_back({of_tet.value[i], of_tet.gradient[i]});
    }
}

// Without its part along the normal.
Vec3 across(Vec3 a, Vec3 normal) {
    const double size_2 = dot(normal, normal);
    return size_2 > 0 ? a - normal * (dot(a, normal) / size_2) : a;
}

Vec3 ascent(const std::vector<Term>& terms, double least, Vec3 normal, std::vector<Vec3>& pulls) {
    pulls.clear();
    for (const Term& term : terms) {
        if (term.value <= least * (1 + active_share)) pulls.push_back(across(term.gradient, normal));
    }
    return shortest_in_hull(pulls);
}

// How far to go along a direction until, by linear prediction, some other function becomes the minimum.
double predicted_step(const std::vector<Term>& terms, double least, Vec3 direction) {
    const double slope = dot(direction, direction);
    double step = 1e300;
    for (const Term& term : terms) {
        const double own = dot(term.gradient, direction);
        if (term.value > least * (1 + active_share) && own < slope)
            step = std::min(step, (term.value - least) / (slope - own));
    }
    return step;
}

// The longest step tried: half the way to the farthest corner.
double longest_step(Vec3 node, const std::vector<OppositeFace>& faces) {
    double reach_2 = 0;
    for (const OppositeFace& face : faces) reach_2 = std::max(reach_2, dot(face[0] - node, face[0] - node));
    return 0.5 * std::sqrt(reach_2);
}

// The worst shape at a place, or something not above `floor` as soon as that is clear. The tet that spoiled a place is
// asked first next time.
double least_at(Vec3 node, std::vector<OppositeFace>& faces, double floor) {
    double least = 1;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        least = std::min(least, faces[i].shape_from(node));
        if (least > floor) continue;
        std::swap(faces[0], faces[i]);
        return least;
    }
    return least;
}

}

// Gilbert's algorithm: from the nearest point found so far towards the vector that lies farthest behind it.
Vec3 shortest_in_hull(std::span<const Vec3> vectors) {
    if (vectors.empty()) return {};
    Vec3 nearest = vectors[0];
    for (const Vec3& v : vectors) {
        if (dot(v, v) < dot(nearest, nearest)) nearest = v;
    }
    for (int round = 0; round < 40; ++round) {
        const Vec3* lowest = &vectors[0];
        for (const Vec3& v : vectors) {
            if (dot(v, nearest) < dot(*lowest, nearest)) lowest = &v;
        }
        const double length_2 = dot(nearest, nearest);
        const double behind = length_2 - dot(*lowest, nearest);
        if (!(behind > 0.01 * length_2)) break;
        const Vec3 towards = *lowest - nearest;
        const double share = std::clamp(behind / dot(towards, towards), 0.0, 1.0);
        nearest += towards * share;
    }
    return nearest;
}

std::optional<BetterPlace> find_better_place(Vec3 node, std::vector<OppositeFace>& faces, double floor,
                                             const Leash& leash) {
    std::vector<Term> terms;
    std::vector<Vec3> pulls;
    BetterPlace best{node, least_at(node, faces, -1)};
    if (!(best.least > 0)) return std::nullopt;
    const double start = best.least;
    const double reach = longest_step(node, faces);
    for (int step = 0; step < max_steps; ++step) {
        collect_terms(best.place, faces, terms);
        const Vec3 direction = ascent(terms, best.least, leash.normal, pulls);
        const double speed = length(direction);
        if (!(speed * reach > 1e-3 * best.least)) break;
        double along = std::min(predicted_step(terms, best.least, direction), reach / speed);
        const double before = best.least;
        for (int halving = 0; halving <= max_halvings; ++halving, along *= 0.5) {
            const Vec3 place = round_to_float(best.place + direction * along);
            if (length(place - node) > leash.reach) continue;
            const double least = least_at(place, faces, best.least);
            if (!(least > best.least)) continue;
            best = {place, least};
            break;
        }
        if (!(best.least > before * (1 + worthwhile_share))) break;
    }
    if (!(best.least > std::max(floor, start))) return std::nullopt;
    return best;
}

}
