// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/add_nodes.h"

#include <algorithm>
#include <utility>

namespace crumple::finish {

namespace {

// Moving a node costs no tets, but must be worth the work.
constexpr double price_of_move = 0.1;

// What a plan costs, in operations: it fits eight holes and places to each other.
constexpr std::uint64_t operations_of_plan = 150;

}

NodeAdder::NodeAdder(WorkMesh& mesh, const NodeLimits& limits)
    : mesh_(mesh), bad_(shape_of_angle(limits.bad_deg)), limits_(limits) {}

NodeReport NodeAdder::run(double level, std::uint64_t budget, const Context& context) {
    report_ = {};
    budget_ = budget;
    plan_all(context);
    while (!waiting_.empty() && !(waiting_.top().gain < level)) {
        context.stop_if_cancelled();
        const Index next = waiting_.top().plan;
        waiting_.pop();
        if (is_stale(plans_[next])) {
            const Index tet = plans_[next].tet;
            plans_[next].insertion = {};
            if (plans_[next].moved != none) node_planned_at_[plans_[next].moved] = 0;
            if (is_bad(tet)) plan(tet);
            continue;
        }
        carry_out(std::move(plans_[next]));
    }
    return report_;
}

bool NodeAdder::is_bad(Index tet) const { return mesh_.complex.is_tet(tet) && mesh_.shape(tet) < bad_; }

bool NodeAdder::has_changed_since(Index tet, std::uint64_t clock) const {
    const Tet& corners = mesh_.complex.corners(tet);
    return std::any_of(corners.begin(), corners.end(), [&](Index v) { return mesh_.changed_at[v] > clock; });
}

bool NodeAdder::is_stale(const Plan& plan) const {
    const std::vector<Index>& old = plan.insertion.exchange.old;
    return std::any_of(old.begin(), old.end(),
                       [&](Index t) { return !mesh_.complex.is_tet(t) || has_changed_since(t, plan.made_at); });
}

// Every bad tet that changed since it was last planned for.
void NodeAdder::plan_all(const Context& context) {
    planned_at_.resize(mesh_.complex.slot_count(), 0);
    for (Index t = 0; t < mesh_.complex.slot_count(); ++t) {
        if (!is_bad(t) || !has_changed_since(t, planned_at_[t])) continue;
        context.stop_if_cancelled();
        plan(t);
    }
}

void NodeAdder::plan(Index tet) {
    report_.is_out_of_budget |= report_.tried + operations_of_plan > budget_;
    if (report_.is_out_of_budget) return;
    report_.tried += operations_of_plan;
    planned_at_.resize(mesh_.complex.slot_count(), 0);
    planned_at_[tet] = mesh_.clock;
    Plan plan{tet, none, mesh_.clock, {}};
    double best = 0;
    if (plan_new_node(mesh_, tet, bad_, limits_.price, plan.insertion)) best = plan.insertion.gain - limits_.price;
    plan_moves(tet, best, plan);
    if (!(best > 0)) return;
    waiting_.push({best, static_cast<Index>(plans_.size())});
    plans_.push_back(std::move(plan));
}

void NodeAdder::plan_moves(Index tet, double& best, Plan& plan) {
    node_planned_at_.resize(mesh_.changed_at.size(), 0);
    const Tet corners = mesh_.complex.corners(tet);
    for (const Index v : corners) {
        if (!mesh_.is_free[v] || mesh_.changed_at[v] <= node_planned_at_[v]) continue;
        node_planned_at_[v] = mesh_.clock;
        mesh_.complex.star_of(v, star_);
        if (!plan_reseat(mesh_, v, star_, bad_, best + price_of_move, trial_)) continue;
        best = trial_.gain - price_of_move;
        plan.moved = v;
        std::swap(plan.insertion, trial_);
    }
}

void NodeAdder::carry_out(Plan chosen) {
    Exchange& exchange = chosen.insertion.exchange;
    const Index node = add_node(mesh_, chosen.insertion.place);
    for (Tet& fresh : exchange.fresh) fresh[0] = node;
    ++(chosen.moved == none ? report_.added : report_.reseated);
    const std::span<const Index> slots = apply(mesh_, exchange);
    const std::vector<Index> fresh(slots.begin(), slots.end());
    for (const Index t : fresh) {
        if (is_bad(t)) plan(t);
    }
}

}
