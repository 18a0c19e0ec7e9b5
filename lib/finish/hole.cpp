// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/hole.h"

#include <algorithm>

#include "finish/node_operations.h"
#include "finish/place_search.h"

namespace crumple::finish {

namespace {

// Of two places with the same badness the one of the better worst tet is taken: shapes are below 1, and a tenth of one
// never outweighs a tet.
constexpr double shape_weight = 0.1;

// What a hole is grown by must gain more than rounding.
constexpr double least_gain = 1e-9;

}

double badness_of(double shape, double bad) { return shape < bad ? 1 - 0.5 * shape / bad : 0; }

Hole::Hole(const WorkMesh& mesh, Vec3 place, std::span<const Index> tets) : mesh_(mesh), place_(round_to_float(place)) {
    for (const Index t : tets) add(t);
}

bool Hole::open(double least, std::size_t most) {
    while (!rim_.empty()) {
        const auto worst =
            std::min_element(rim_.begin(), rim_.end(), [](const Rim& a, const Rim& b) { return a.shape < b.shape; });
        if (worst->shape > least) return true;
        if (!may_take(worst->outer, most)) return false;
        add(worst->outer);
    }
    return false;
}

void Hole::grow(double bad, std::size_t most) {
    for (;;) {
        double best = least_gain;
        Index next = none;
        for (const Rim& r : rim_) {
            if (!may_take(r.outer, most)) continue;
            const double gain = gain_of(r.outer, bad);
            if (!(gain > best)) continue;
            best = gain;
            next = r.outer;
        }
        if (next == none) return;
        add(next);
    }
}

void Hole::settle() {
    std::vector<OppositeFace> around = faces();
    if (const auto better = find_better_place(place_, around, 0)) move_to(better->place);
}

void Hole::settle_badness(double bad) {
    if (!(new_badness(bad) > 0)) return;
    double reach = 0;
    for (const Rim& r : rim_) {
        for (int i = 0; i < 3; ++i) reach = std::max(reach, length(r.at[i] - place_));
    }
    const auto lack = [&](Vec3 place, double limit) { return lack_at(place, bad, limit); };
    move_to(search_place(place_, reach, lack(place_, 1e300), lack));
}

double Hole::old_badness(double bad) const {
    double sum = 0;
    for (const Index t : tets_) sum += badness_of(mesh_.shape(t), bad);
    return sum;
}

double Hole::new_badness(double bad) const {
    double sum = 0;
    for (const Rim& r : rim_) sum += badness_of(r.shape, bad);
    return sum;
}

double Hole::least() const {
    double least = 1;
    for (const Rim& r : rim_) least = std::min(least, r.shape);
    return least;
}

bool Hole::is_sound(bool may_lose_free_nodes) const {
    const auto is_kept = [&](Index v) {
        return (may_lose_free_nodes && mesh_.is_free[v]) || std::any_of(rim_.begin(), rim_.end(), [v](const Rim& r) {
                   return std::find(r.face.begin(), r.face.end(), v) != r.face.end();
               });
    };
    for (const Index t : tets_) {
        const Tet& corners = mesh_.complex.corners(t);
        if (!std::all_of(corners.begin(), corners.end(), is_kept)) return false;
    }
    return is_positive_towards(place_, faces());
}

void Hole::write(Exchange& exchange) const {
    exchange.clear();
    exchange.old = tets_;
    exchange.least = least();
    for (const Rim& r : rim_) exchange.fresh.push_back({none, r.face[0], r.face[1], r.face[2]});
}

void Hole::add(Index tet) {
    tets_.push_back(tet);
    std::erase_if(rim_, [&](const Rim& r) { return r.outer == tet; });
    const Tet& corners = mesh_.complex.corners(tet);
    for (int corner = 0; corner < 4; ++corner) {
        const Index outer = mesh_.complex.neighbour(tet, corner);
        if (holds(outer)) continue;
        const Triangle face = facing(corners, corner);
        const OppositeFace at = places_of(mesh_, face);
        rim_.push_back({face, at, outer, at.shape_from(place_)});
    }
}

void Hole::move_to(Vec3 place) {
    place_ = place;
    for (Rim& r : rim_) r.shape = r.at.shape_from(place_);
}

bool Hole::holds(Index tet) const { return tet != none && std::find(tets_.begin(), tets_.end(), tet) != tets_.end(); }

bool Hole::may_take(Index tet, std::size_t most) const {
    return tet != none && tets_.size() < most && mesh_.complex.region(tet) == mesh_.complex.region(tets_[0]);
}

// What taking in a neighbour takes off the badness, -1 when the node does not see all of it.
double Hole::gain_of(Index tet, double bad) const {
    double gain = badness_of(mesh_.shape(tet), bad);
    for (const Rim& r : rim_) {
        if (r.outer == tet) gain += badness_of(r.shape, bad);
    }
    const Tet& corners = mesh_.complex.corners(tet);
    for (int corner = 0; corner < 4; ++corner) {
        if (holds(mesh_.complex.neighbour(tet, corner))) continue;
        const double shape = places_of(mesh_, facing(corners, corner)).shape_from(place_);
        if (!(shape > 0)) return -1;
        gain -= badness_of(shape, bad);
    }
    return gain;
}

// Badness at a place, the worst shape for ties; something above `limit` as soon as that is clear.
double Hole::lack_at(Vec3 place, double bad, double limit) const {
    double sum = 0;
    double least = 1;
    for (const Rim& r : rim_) {
        const double shape = r.at.shape_from(place);
        if (!(shape > 0)) return 1e300;
        sum += badness_of(shape, bad);
        least = std::min(least, shape);
        if (sum > limit + shape_weight) return 1e300;
    }
    return sum - shape_weight * least;
}

std::vector<OppositeFace> Hole::faces() const {
    std::vector<OppositeFace> faces;
    faces.reserve(rim_.size());
    for (const Rim& r : rim_) faces.push_back(r.at);
    return faces;
}

}
