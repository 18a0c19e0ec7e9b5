// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/repair.h"

#include <algorithm>
#include <set>
#include <vector>

#include "finish/give_way.h"
#include "finish/surface_changes.h"
#include "mesh/boundary.h"

namespace crumple::finish {

namespace {

// Changes that mend one node and spoil another, at most: each asks all bad nodes.
constexpr int max_sideways = 50;

// Changes weighed at most: a mesh that is bad all over is not made good by taking it apart.
constexpr int max_weighed = 50000;

// And of those that need new nodes.
constexpr int max_cuts = 5000;

class Repairer {
public:
    Repairer(TetMesh mesh, std::span<const std::uint8_t> locked)
        : surface_(boundary_of(mesh).faces),
          space_(mesh.positions, surface_),
          locked_(locked),
          tets_(std::move(mesh)) {}

    Repaired run(const Context& context) {
        const NonManifold wrong = non_manifold(surface_);
        report_.edges_before = wrong.edges.size();
        report_.nodes_before = wrong.vertices.size();
        waiting_.insert(wrong.vertices.begin(), wrong.vertices.end());
        // A change leaves fewer bad nodes than before, or is one of a limited number that do not: this ends.
        while (!waiting_.empty() && weighed_ < max_weighed) {
            context.stop_if_cancelled();
            const SurfaceChange best = best_change();
            if (best.is_empty()) break;
            carry_out(best);
        }
        while (let_parts_give_way(context)) continue;
        report_.nodes_left = waiting_.size();
        return {std::move(tets_).take(), report_};
    }

private:
    [[nodiscard]] bool may_split(Index node) const { return node >= locked_.size() || !locked_[node]; }

    [[nodiscard]] bool loses_shell_vertex(const SurfaceChange& change) const {
        for (const Index v : tets_.nodes_of(change)) {
            if (v >= tets_.mesh().shell_vertex_count) continue;
            const std::vector<Index> tets = tets_.tets_at(v);
            const auto goes = [&](Index t) {
                return std::find(change.gone.begin(), change.gone.end(), t) != change.gone.end();
            };
            if (!tets.empty() && std::all_of(tets.begin(), tets.end(), goes)) return true;
        }
        return false;
    }

    // How many fewer bad nodes there would be.
    [[nodiscard]] int gain_of(const SurfaceChange& change) {
        ++weighed_;
        const std::vector<Index> nodes = tets_.nodes_of(change);
        int gain = 0;
        tets_.put(change);
        for (const Index v : nodes) gain += int{waiting_.contains(v)} - int{!tets_.is_manifold(v)};
        if (change.split_node != none) gain -= int{!tets_.is_manifold(last_node())};
        tets_.take_back(change);
        return gain;
    }

    [[nodiscard]] Index last_node() const { return static_cast<Index>(tets_.mesh().positions.size() - 1); }

    // The best change of the first bad node that has one: least cost for each node mended. Nodes without wait for their
    // neighbours to change; where all wait, tets go that mend one node and spoil another, for tets come to an end.
    SurfaceChange best_change() {
        SurfaceChange best = best_gaining_change();
        if (!best.is_empty() || sideways_ >= max_sideways) return best;
        for (const Index node : waiting_) {
            if (weighed_ >= max_weighed) break;
            for (SurfaceChange& change : surface_changes_at(tets_, space_, node, false)) {
                const bool is_better = best.is_empty() || change.cost < best.cost;
                if (change.gone.empty() || loses_shell_vertex(change) || !is_better || gain_of(change) < 0) continue;
                best = std::move(change);
            }
        }
        ++sideways_;
        return best;
    }

    // Goes on where the last change was found, once around: a node that has none is not asked again for each change
    // elsewhere.
    SurfaceChange best_gaining_change() {
        const std::vector<Index> behind(waiting_.begin(), waiting_.lower_bound(next_));
        std::vector<Index> order(waiting_.lower_bound(next_), waiting_.end());
        order.insert(order.end(), behind.begin(), behind.end());
        for (const Index node : order) {
            if (weighed_ >= max_weighed) break;
            SurfaceChange best = best_gaining_change_at(node);
            if (best.is_empty()) continue;
            next_ = node;
            return best;
        }
        return {};
    }

    SurfaceChange best_gaining_change_at(Index node) {
        SurfaceChange best;
        double best_cost = 0;
        for (SurfaceChange& change : surface_changes_at(tets_, space_, node, may_split(node))) {
            if (loses_shell_vertex(change)) continue;
            const int gain = gain_of(change);
            if (gain <= 0 || (!best.is_empty() && change.cost / gain >= best_cost)) continue;
            best_cost = change.cost / gain;
            best = std::move(change);
        }
        return best;
    }

    void carry_out(const SurfaceChange& change) {
        std::vector<Index> nodes = tets_.nodes_of(change);
        tets_.put(change);
        if (change.split_node != none) nodes.push_back(last_node());
        mark(nodes);
        report_.removed += change.gone.size();
        report_.added += change.added.size();
        report_.split += change.split_node != none;
        if (!change.gone.empty()) report_.volume_removed += change.cost;
        if (!change.added.empty()) report_.volume_added += change.cost;
    }

    // Enters the bad ones among the nodes and strikes off the good ones.
    void mark(std::span<const Index> nodes) {
        for (const Index v : nodes) {
            if (tets_.is_manifold(v)) {
                waiting_.erase(v);
            } else {
                waiting_.insert(v);
            }
        }
    }

    // What is left gets new nodes, once around. Whether that changed anything.
    bool let_parts_give_way(const Context& context) {
        bool has_changed = false;
        for (const Index node : std::vector<Index>(waiting_.begin(), waiting_.end())) {
            context.stop_if_cancelled();
            for (const Index end : tets_.bad_ends_at(node)) {
                const bool is_bent = gives_way(bend_off_edge(tets_, node, end));
                report_.bent += is_bent;
                has_changed |= is_bent;
            }
            if (!waiting_.contains(node)) continue;
            const bool is_cut = gives_way(cut_tips(tets_, node));
            report_.cut += is_cut;
            has_changed |= is_cut;
        }
        return has_changed;
    }

    // What is wrong with some nodes. Each change leaves less of it: that ends.
    struct Faults {
        std::size_t nodes = 0;
        std::size_t edges = 0;  // from both sides
        auto operator<=>(const Faults&) const = default;
    };

    [[nodiscard]] Faults faults_at(std::span<const Index> nodes) const {
        Faults faults;
        for (const Index v : nodes) {
            faults.nodes += !tets_.is_manifold(v);
            faults.edges += tets_.bad_ends_at(v).size();
        }
        return faults;
    }

    // Tets that no step moves do no harm by touching, and new nodes among them would be loose.
    [[nodiscard]] bool has_rigid_tet(const SurfaceChange& change) const {
        return std::any_of(change.gone.begin(), change.gone.end(), [&](Index t) {
            const Tet& corners = tets_.mesh().tets[t];
            return std::none_of(corners.begin(), corners.end(), [&](Index v) { return may_split(v); });
        });
    }

    // Carries the change out if that leaves less wrong.
    bool gives_way(const SurfaceChange& change) {
        if (change.is_empty() || has_rigid_tet(change) || ++cuts_weighed_ > max_cuts) return false;
        const std::vector<Index> nodes = tets_.nodes_of(change);
        const auto first_new = std::lower_bound(nodes.begin(), nodes.end(), last_node() + 1);
        const Faults before = faults_at({nodes.begin(), first_new});
        tets_.put(change);
        if (!(faults_at(nodes) < before)) {
            tets_.take_back(change);
            return false;
        }
        mark(nodes);
        report_.volume_removed += change.cost;
        return true;
    }

    std::vector<Triangle> surface_;  // as it came: tets that went since leave room, which nobody needs
    OpenSpace space_;
    std::span<const std::uint8_t> locked_;
    TetSelection tets_;
    std::set<Index> waiting_;
    int sideways_ = 0;  // changes that mended no more than they spoilt
    int weighed_ = 0;   // changes so far, done or not
    int cuts_weighed_ = 0;
    Index next_ = 0;  // bad node to ask first
    RepairReport report_;
};

}

Repaired repair_surface(TetMesh mesh, std::span<const std::uint8_t> locked, const Context& context) {
    return Repairer(std::move(mesh), locked).run(context);
}

}
