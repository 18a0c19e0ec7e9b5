// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/improve.h"

#include <algorithm>
#include <queue>

#include "finish/edge_removal.h"
#include "finish/face_removal.h"
#include "finish/node_operations.h"
#include "finish/surface_operations.h"

namespace crumple::finish {

namespace {

// A change must raise the worst shape by this share: keeps the last digits from buying rounds.
constexpr double least_gain = 5e-3;

class Improver {
public:
    Improver(WorkMesh& mesh, const SurfaceGuard& guard, const ImproveLimits& limits)
        : mesh_(mesh), guard_(guard), limits_(limits), target_(shape_of_angle(limits.target_deg)) {}

    ImproveReport run(const Context& context) {
        while (report_.rounds < limits_.rounds && !report_.is_out_of_budget) {
            context.tell_progress("improving shapes", static_cast<double>(report_.rounds) / limits_.rounds);
            if (!run_round(context)) break;
            ++report_.rounds;
        }
        return report_;
    }

private:
    // A tet with its shape when it was put here: another shape now means that it changed since.
    using Entry = std::pair<double, Index>;

    bool run_round(const Context& context) {
        for (Index t = 0; t < mesh_.complex.slot_count(); ++t) {
            if (mesh_.complex.is_tet(t) && is_stirred(t)) offer(t);
        }
        bool has_changed = false;
        while (!waiting_.empty() && !report_.is_out_of_budget) {
            const auto [shape, tet] = waiting_.top();
            waiting_.pop();
            if (!mesh_.complex.is_tet(tet) || mesh_.shape(tet) != shape || !is_stirred(tet)) continue;
            context.stop_if_cancelled();
            mesh_.tried_at[tet] = mesh_.clock;
            has_changed |= mend(tet);
        }
        return has_changed;
    }

    // Something at one of its nodes changed since it was last tried.
    [[nodiscard]] bool is_stirred(Index tet) const {
        const Tet& corners = mesh_.complex.corners(tet);
        return std::any_of(corners.begin(), corners.end(),
                           [&](Index v) { return mesh_.changed_at[v] > mesh_.tried_at[tet]; });
    }

    void offer(Index tet) {
        if (mesh_.shape(tet) < target_) waiting_.emplace(mesh_.shape(tet), tet);
    }

    void offer(std::span<const Index> tets) {
        for (const Index t : tets) offer(t);
    }

    bool spend() {
        report_.is_out_of_budget |= report_.tried >= limits_.budget;
        report_.tried += !report_.is_out_of_budget;
        return !report_.is_out_of_budget;
    }

    bool mend(Index tet) {
        return mend_by_exchange(tet) || mend_by_move(tet) || mend_by_slide(tet) || mend_by_contraction(tet);
    }

    // The best of all edges and faces of the tet.
    bool mend_by_exchange(Index tet) {
        double floor = mesh_.shape(tet) * (1 + least_gain);
        std::uint64_t* counter = nullptr;
        const Tet corners = mesh_.complex.corners(tet);
        for (const auto& edge : tet_edge_corners) {
            mesh_.complex.ring_of(tet, corners[edge[0]], corners[edge[1]], ring_);
            if (least_shape(mesh_, ring_.tets) < mesh_.shape(tet) || !spend()) continue;
            const RemovalResult result =
                plan_edge_removal(mesh_, &guard_, ring_, corners[edge[0]], corners[edge[1]], floor, exchange_);
            if (result == RemovalResult::none) continue;
            keep_best(floor);
            counter = result == RemovalResult::surface ? &report_.surface_flips : &report_.edge_removals;
        }
        for (int corner = 0; corner < 4; ++corner) {
            if (!spend() || !plan_face_removal(mesh_, tet, corner, floor, exchange_)) continue;
            keep_best(floor);
            counter = &report_.face_removals;
        }
        if (counter == nullptr) return false;
        ++*counter;
        offer(apply(mesh_, best_));
        return true;
    }

    void keep_best(double& floor) {
        floor = exchange_.least;
        std::swap(best_, exchange_);
    }

    // Stars in which a better tet's node would have to wait for a worse one are left to that one.
    bool find_own_star(Index tet, Index node) {
        mesh_.complex.star_of(node, star_);
        return least_shape(mesh_, star_) >= mesh_.shape(tet);
    }

    bool mend_by_move(Index tet) {
        const Tet corners = mesh_.complex.corners(tet);
        const double floor = mesh_.shape(tet) * (1 + least_gain);
        bool has_moved = false;
        for (const Index v : corners) {
            if (!mesh_.is_free[v] || !find_own_star(tet, v) || !spend()) continue;
            const auto better = plan_move(mesh_, v, star_, floor);
            if (!better) continue;
            move_node(mesh_, v, better->place, star_);
            ++report_.moves;
            offer(star_);
            has_moved = true;
        }
        return has_moved;
    }

    // A shell vertex on a smooth part of the surface.
    [[nodiscard]] bool may_slide(Index node) const {
        const std::vector<std::uint8_t>& smooth = guard_.smooth_vertices();
        return node < smooth.size() && smooth[node] && mesh_.is_on_surface[node] && !mesh_.is_pinched[node];
    }

    bool mend_by_slide(Index tet) {
        if (!(limits_.slide > 0)) return false;
        const Tet corners = mesh_.complex.corners(tet);
        const double floor = mesh_.shape(tet) * (1 + least_gain);
        for (const Index v : corners) {
            if (!may_slide(v) || !find_own_star(tet, v) || !is_of_one_region(mesh_, star_) || !spend()) continue;
            const auto better =
                plan_slide(mesh_, guard_, v, star_, guard_.home(v), limits_.slide * shortest_edge(v), floor);
            if (!better) continue;
            move_node(mesh_, v, better->place, star_);
            ++report_.slides;
            offer(star_);
            return true;
        }
        return false;
    }

    // At a node of star_, at its home.
    [[nodiscard]] double shortest_edge(Index node) const {
        double shortest = 1e300;
        for (const Index t : star_) {
            for (const Index v : mesh_.complex.corners(t)) {
                if (v != node) shortest = std::min(shortest, length(mesh_.at(v) - guard_.home(node)));
            }
        }
        return shortest;
    }

    bool mend_by_contraction(Index tet) {
        const Tet corners = mesh_.complex.corners(tet);
        double floor = mesh_.shape(tet) * (1 + least_gain);
        bool is_found = false;
        for (const Index v : corners) {
            if (!(mesh_.is_free[v] || mesh_.is_surplus[v]) || !find_own_star(tet, v)) continue;
            for (const Index target : corners) {
                if (target == v || !spend() || !plan_merge(v, target, floor)) continue;
                keep_best(floor);
                is_found = true;
            }
        }
        if (!is_found) return false;
        ++report_.contractions;
        offer(apply(mesh_, best_));
        return true;
    }

    bool plan_merge(Index node, Index target, double floor) {
        return mesh_.is_free[node] ? plan_contraction(mesh_, node, star_, target, floor, exchange_)
                                   : plan_surface_operations(mesh_, guard_, node, star_, target, floor, exchange_);
    }

    WorkMesh& mesh_;
    const SurfaceGuard& guard_;
    const ImproveLimits& limits_;
    double target_;
    ImproveReport report_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting_;

    // Working memory.
    TetRing ring_;
    std::vector<Index> star_;
    Exchange exchange_;
    Exchange best_;
};

}

ImproveReport improve_shapes(WorkMesh& mesh, const SurfaceGuard& guard, const ImproveLimits& limits,
                             const Context& context) {
    return Improver(mesh, guard, limits).run(context);
}

}
