// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/raise_steps.h"

#include <algorithm>
#include <set>

#include "finish/edge_removal.h"
#include "finish/face_removal.h"
#include "finish/insertion.h"
#include "finish/node_steps.h"
#include "finish/place_search.h"
#include "geometry/predicates.h"

namespace crumple::finish {

namespace {

// A change must raise the least step by this share, one that costs a node by more.
constexpr double least_gain = 0.05;
constexpr double gain_for_a_node = 0.15;

// Nodes whose step is this many times that of the worst one that nothing helps set nobody's step.
constexpr double enough = 1.5;

// Shapes may give this share, but a tet above the first of these angles stays above it, and one above the second is
// good enough.
constexpr double kept_shape = 0.8;
constexpr double bad_deg = 10.2;
constexpr double good_deg = 20;

class Raiser {
public:
    Raiser(WorkMesh& mesh, const SurfaceGuard& guard, const StepLimits& limits)
        : mesh_(mesh),
          guard_(guard),
          limits_(limits),
          bad_(shape_of_angle(bad_deg)),
          good_(shape_of_angle(good_deg)),
          steps_(mesh) {}

    StepReport run(const Context& context) {
        for (Index v = 0; v < steps_.node_count(); ++v) offer(v);
        if (waiting_.empty()) return report_;
        const double worth_it = limits_.share * median();
        double stuck = 1e300;
        while (!waiting_.empty() && report_.tried < limits_.budget) {
            context.stop_if_cancelled();
            const auto [step, node] = *waiting_.begin();
            if (step > worth_it || step > enough * stuck) break;
            if (relieve(node)) continue;
            waiting_.erase(waiting_.begin());
            stuck = std::min(stuck, step);
        }
        return report_;
    }

private:
    void offer(Index node) {
        if (steps_.step(node) > 0) waiting_.emplace(steps_.step(node), node);
    }

    [[nodiscard]] double median() const {
        auto middle = waiting_.begin();
        std::advance(middle, static_cast<std::ptrdiff_t>(waiting_.size() / 2));
        return middle->first;
    }

    // What the shapes that come must be above where the worst that goes is `least`.
    [[nodiscard]] double floor_of(double least) const {
        return least < bad_ ? least : std::clamp(kept_shape * least, bad_, good_);
    }

    // The best of all changes at the node's tets.
    bool relieve(Index node) {
        own_ = steps_.step(node);
        wanted_ = own_ * (1 + least_gain);
        best_.exchange.clear();
        mesh_.complex.star_of(node, star_);
        for (const Index tet : star_) {
            for (const auto& edge : tet_edge_corners) try_edge(tet, edge[0], edge[1]);
            for (int corner = 0; corner < 4; ++corner) try_face(tet, corner);
        }
        for (const Index v : free_nodes_around()) try_move(v);
        if (best_.exchange.old.empty()) return false;
        carry_out();
        return true;
    }

    [[nodiscard]] std::vector<Index> free_nodes_around() const {
        std::vector<Index> nodes;
        for (const Index t : star_) {
            for (const Index v : mesh_.complex.corners(t)) {
                if (mesh_.is_free[v]) nodes.push_back(v);
            }
        }
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        return nodes;
    }

    void try_edge(Index tet, int i, int j) {
        const Index a = mesh_.complex.corners(tet)[i];
        const Index b = mesh_.complex.corners(tet)[j];
        mesh_.complex.ring_of(tet, a, b, ring_);
        const double floor = floor_of(least_shape(mesh_, ring_.tets));
        ++report_.tried;
        trial_ = {};
        if (plan_edge_removal(mesh_, &guard_, ring_, a, b, floor, trial_.exchange) != RemovalResult::none)
            consider(least_gain);
        ++report_.tried;
        if (!plan_insertion_on_edge(mesh_, ring_, a, b, floor, insertion_)) return;
        trial_ = {insertion_.exchange, true, none, insertion_.place};
        settle(floor);
        consider(gain_for_a_node);
    }

    void try_face(Index tet, int corner) {
        ++report_.tried;
        trial_ = {};
        if (plan_face_removal(mesh_, tet, corner, floor_of(mesh_.shape(tet)), trial_.exchange)) consider(least_gain);
    }

    void try_move(Index node) {
        trial_ = {{}, true, node, mesh_.at(node)};
        Exchange& exchange = trial_.exchange;
        mesh_.complex.star_of(node, exchange.old);
        for (const Index t : exchange.old) exchange.fresh.push_back(mesh_.complex.corners(t));
        settle(floor_of(least_shape(mesh_, exchange.old)));
        if (trial_.place != mesh_.at(node)) consider(least_gain);
    }

    // Moves the placed node of the trial to where the least step is largest.
    void settle(double floor) {
        const double start = steps_.weigh(mesh_, trial_).after;
        trial_.place = search_place(trial_.place, reach(), -start, [&](Vec3 place, double) {
            trial_.place = place;
            ++report_.tried;
            return holds_shapes(floor) ? -steps_.weigh(mesh_, trial_).after : 1e300;
        });
    }

    [[nodiscard]] double reach() const {
        double farthest = 0;
        for (const Tet& t : trial_.exchange.fresh) {
            for (const Index v : t) farthest = std::max(farthest, length(trial_.at(mesh_, v) - trial_.place));
        }
        return farthest;
    }

    [[nodiscard]] bool holds_shapes(double floor) const {
        return std::all_of(trial_.exchange.fresh.begin(), trial_.exchange.fresh.end(), [&](const Tet& t) {
            const Vec3 a = trial_.at(mesh_, t[0]);
            const Vec3 b = trial_.at(mesh_, t[1]);
            const Vec3 c = trial_.at(mesh_, t[2]);
            const Vec3 d = trial_.at(mesh_, t[3]);
            return shape_of(a, b, c, d) > floor && orient3d(a, b, c, d) > 0;
        });
    }

    // Keeps the trial when no change so far is as good.
    void consider(double gain) {
        const NodeSteps::Least least = steps_.weigh(mesh_, trial_);
        if (least.before < own_ || least.after <= std::max(wanted_, own_ * (1 + gain))) return;
        wanted_ = least.after;
        best_ = trial_;
    }

    void carry_out() {
        (void)steps_.weigh(mesh_, best_);
        std::vector<Index> touched = steps_.nodes();
        for (const Index v : touched) waiting_.erase({steps_.step(v), v});
        const Index added = best_.adds_node() ? add_node(mesh_, best_.place) : none;
        steps_.carry_out(mesh_, best_, added);
        if (best_.adds_node()) {
            touched.push_back(added);
            for (Tet& t : best_.exchange.fresh) t[0] = added;
        }
        if (best_.moves_node()) {
            move_node(mesh_, best_.placed, best_.place, best_.exchange.old);
        } else {
            (void)apply(mesh_, best_.exchange);
        }
        for (const Index v : touched) offer(v);
        ++report_.changes;
    }

    WorkMesh& mesh_;
    const SurfaceGuard& guard_;
    const StepLimits& limits_;
    double bad_;
    double good_;
    NodeSteps steps_;
    std::set<std::pair<double, Index>> waiting_;  // by step
    StepReport report_;

    // Of the node at hand.
    double own_ = 0;
    double wanted_ = 0;
    Change best_;

    // Working memory.
    Change trial_;
    TetRing ring_;
    std::vector<Index> star_;
    Insertion insertion_;
};

}

StepReport raise_steps(WorkMesh& mesh, const SurfaceGuard& guard, const StepLimits& limits, const Context& context) {
    return Raiser(mesh, guard, limits).run(context);
}

}
