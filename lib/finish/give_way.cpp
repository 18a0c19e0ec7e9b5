// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/give_way.h"

#include <algorithm>
#include <utility>

#include "finish/shape.h"
#include "geometry/measures.h"
#include "geometry/predicates.h"

namespace crumple::finish {

namespace {

// From the middle of an edge towards what lies across it, a part is bent by so much; halved where a tet would turn
// inside out.
constexpr double first_bend = 0.25;
constexpr double least_bend = 0.03;

// Where the edges at a node are cut, seen from it: a twentieth of the tets' volume goes. The next one where rounding
// turns a flat tet inside out.
constexpr double cut_shares[] = {0.35, 0.45, 0.55, 0.3, 0.65};

double volume_of(const TetSelection& tets, const std::vector<Index>& part) {
    double sum = 0;
    for (const Index t : part) sum += tets.volume(t);
    return sum;
}

// A change that puts tets at new nodes in the place of others.
class Refining {
public:
    explicit Refining(const TetSelection& tets)
        : tets_(&tets), next_(static_cast<Index>(tets.mesh().positions.size())) {}

    Index add_node(Vec3 place) {
        change_.places.push_back(round_to_float(place));
        return next_++;
    }

    void take(Index tet) {
        change_.gone.push_back(tet);
        change_.cost += tets_->volume(tet);
    }

    // That a tet is positive, although it is not put.
    void require(const Tet& tet) {
        const auto& [a, b, c, d] = tet;
        is_sound_ &= orient3d(at(a), at(b), at(c), at(d)) > 0;
    }

    void put(const Tet& tet, Index like) {
        const auto& [a, b, c, d] = tet;
        require(tet);
        change_.added.push_back(tet);
        change_.like.push_back(like);
        change_.cost -= signed_volume(at(a), at(b), at(c), at(d));
    }

    [[nodiscard]] bool is_sound() const { return is_sound_; }
    [[nodiscard]] SurfaceChange take_change() && { return is_sound_ ? std::move(change_) : SurfaceChange{}; }

private:
    [[nodiscard]] Vec3 at(Index node) const {
        const std::vector<Vec3>& known = tets_->mesh().positions;
        return node < known.size() ? known[node] : change_.places[node - known.size()];
    }

    const TetSelection* tets_;
    Index next_;
    SurfaceChange change_;
    bool is_sound_ = true;
};

Tet with(Tet tet, Index old, Index fresh) {
    std::replace(tet.begin(), tet.end(), old, fresh);
    return tet;
}

// A part of tets around an edge, and a place in it to bend it off the edge.
class Fan {
public:
    Fan(const TetSelection& tets, const std::vector<Index>& part, const Edge& edge)
        : tets_(tets), part_(part), edge_(edge), middle_((at(edge[0]) + at(edge[1])) * 0.5) {}

    // Where to bend to: the middle of all, and if the fan is so wide that this lies outside, towards each node around
    // the edge.
    [[nodiscard]] std::vector<Vec3> targets() const {
        std::vector<Vec3> targets{{}};
        for (const Index t : part_) {
            for (const Index v : tets_.mesh().tets[t]) {
                if (v == edge_[0] || v == edge_[1]) continue;
                targets[0] += at(v) / (2 * static_cast<double>(part_.size()));
                targets.push_back(at(v));
            }
        }
        return targets;
    }

    // With a node of its own, a share of the way from the edge to there.
    void bend(Vec3 target, double share, Refining& refining) const {
        const Index node = refining.add_node(middle_ + (target - middle_) * share);
        for (const Index t : part_) {
            refining.take(t);
            for (const Index end : edge_) refining.put(with(tets_.mesh().tets[t], end, node), t);
            for (int corner = 0; corner < 4; ++corner) {
                if (is_rim(t, corner)) refining.require(with(tets_.mesh().tets[t], tets_.mesh().tets[t][corner], node));
            }
        }
    }

private:
    [[nodiscard]] Vec3 at(Index node) const { return tets_.mesh().positions[node]; }

    // Whether the face opposite a corner holds the edge and is one where the fan ends.
    [[nodiscard]] bool is_rim(Index tet, int corner) const {
        const Index opposite = tets_.mesh().tets[tet][corner];
        if (opposite == edge_[0] || opposite == edge_[1]) return false;
        return std::find(part_.begin(), part_.end(), tets_.neighbour(tet, corner)) == part_.end();
    }

    const TetSelection& tets_;
    const std::vector<Index>& part_;
    Edge edge_;
    Vec3 middle_;
};

// The whole part must see the node: then its tets with the node overlap nothing.
bool bend(const TetSelection& tets, const std::vector<Index>& part, const Edge& edge, Refining& refining) {
    const Fan fan(tets, part, edge);
    for (const Vec3 target : fan.targets()) {
        for (double share = first_bend; share > least_bend; share *= 0.5) {
            Refining trial = refining;
            fan.bend(target, share, trial);
            if (!trial.is_sound()) continue;
            refining = std::move(trial);
            return true;
        }
    }
    return false;
}

// A tet as its node and the three others, ascending; is_odd: swap two of them and it is positive.
struct Corners {
    Tet tet;
    bool is_odd;
};

Corners sorted_from(Tet tet, Index node) {
    bool is_odd = false;
    const auto order = [&](int i, int j, bool is_wrong) {
        if (!is_wrong) return;
        std::swap(tet[i], tet[j]);
        is_odd = !is_odd;
    };
    for (int i = 1; i < 4; ++i) order(0, i, tet[i] == node);
    order(1, 2, tet[1] > tet[2]);
    order(2, 3, tet[2] > tet[3]);
    order(1, 2, tet[1] > tet[2]);
    return {tet, is_odd};
}

// The places where the edges at a node are cut.
class Cuts {
public:
    Cuts(const TetSelection& tets, Index node, double share, Refining& refining) {
        const TetMesh& mesh = tets.mesh();
        for (const Index t : tets.tets_at(node)) ends_.insert(ends_.end(), mesh.tets[t].begin(), mesh.tets[t].end());
        std::sort(ends_.begin(), ends_.end());
        ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
        std::erase(ends_, node);
        const Vec3 from = mesh.positions[node];
        for (const Index end : ends_) nodes_.push_back(refining.add_node(from + (mesh.positions[end] - from) * share));
    }

    [[nodiscard]] Index towards(Index end) const {
        return nodes_[static_cast<std::size_t>(std::lower_bound(ends_.begin(), ends_.end(), end) - ends_.begin())];
    }

private:
    std::vector<Index> ends_;
    std::vector<Index> nodes_;
};

// Of the tets at a node, the one with the best shape.
Index best_of(const TetSelection& tets, const std::vector<Index>& star) {
    const auto shape = [&](Index t) {
        const auto& [a, b, c, d] = tets.mesh().tets[t];
        const std::vector<Vec3>& at = tets.mesh().positions;
        return shape_of(at[a], at[b], at[c], at[d]);
    };
    return *std::max_element(star.begin(), star.end(), [&](Index a, Index b) { return shape(a) < shape(b); });
}

void cut_star(const TetSelection& tets, Index node, double share, Refining& refining) {
    const std::vector<Index> star = tets.tets_at(node);
    if (star.empty()) return;
    const Cuts cuts(tets, node, share, refining);
    const Index kept = best_of(tets, star);
    for (const Index t : star) {
        const auto [tet, is_odd] = sorted_from(tets.mesh().tets[t], node);
        const bool swaps = is_odd;  // clang 14 captures no structured binding
        const auto put = [&](Index a, Index b, Index c, Index d) {
            refining.put(swaps ? Tet{a, b, d, c} : Tet{a, b, c, d}, t);
        };
        const Index i = cuts.towards(tet[1]);
        const Index j = cuts.towards(tet[2]);
        const Index k = cuts.towards(tet[3]);
        refining.take(t);
        put(i, tet[1], tet[2], tet[3]);
        put(j, i, tet[2], tet[3]);
        put(k, i, j, tet[3]);
        if (t == kept) put(node, i, j, k);
    }
}

}

SurfaceChange bend_off_edge(const TetSelection& tets, Index node, Index end) {
    std::vector<std::vector<Index>> parts = tets.parts_at(node, end);
    if (parts.size() < 2) return {};
    const auto largest = std::max_element(parts.begin(), parts.end(), [&](const auto& a, const auto& b) {
        return volume_of(tets, a) < volume_of(tets, b);
    });
    parts.erase(largest);
    Refining refining(tets);
    for (const std::vector<Index>& part : parts) {
        if (!bend(tets, part, {node, end}, refining)) return {};
    }
    return std::move(refining).take_change();
}

// Edges are cut in the order of their other ends: so neighbours agree on how their common sides are divided.
SurfaceChange cut_tips(const TetSelection& tets, Index node) {
    for (const double share : cut_shares) {
        Refining refining(tets);
        cut_star(tets, node, share, refining);
        if (refining.is_sound()) return std::move(refining).take_change();
    }
    return {};
}

}
