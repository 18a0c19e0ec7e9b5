// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/finish.h"

#include <algorithm>

#include "finish/add_nodes.h"
#include "finish/crowded.h"
#include "finish/findings.h"
#include "finish/flaps.h"
#include "finish/improve.h"
#include "finish/peel.h"
#include "finish/raise_steps.h"
#include "finish/repair.h"
#include "finish/strip.h"
#include "finish/surface_guard.h"
#include "finish/work_mesh.h"

namespace crumple::finish {

namespace {

void check_input(const Shell& shell, const TetMesh& mesh) {
    CRUMPLE_CHECK(mesh.shell_vertex_count == shell.positions.size(), "finish needs the shell its mesh was made of");
    CRUMPLE_CHECK(mesh.positions.size() >= shell.positions.size(), "a mesh holds its shell's vertices");
    CRUMPLE_CHECK(std::equal(shell.positions.begin(), shell.positions.end(), mesh.positions.begin()),
                  "shell vertices come first, at their place");
    CRUMPLE_CHECK(mesh.neighbours.size() == mesh.tets.size(), "every tet has its neighbours");
    CRUMPLE_CHECK(mesh.region.empty() || mesh.region.size() == mesh.tets.size(), "every tet has its region");
}

void repair(TetMesh& mesh, const Shell& shell, Report& report, const Context& context) {
    Repaired repaired = repair_surface(std::move(mesh), shell.locked, context);
    mesh = std::move(repaired.mesh);
    const RepairReport& r = repaired.report;
    report.repair = {r.edges_before, r.nodes_before, r.nodes_left, r.removed,        r.added,
                     r.split,        r.bent,         r.cut,        r.volume_removed, r.volume_added};
}

double largest_slide(const Shell& shell, const TetMesh& mesh) {
    double largest = 0;
    for (std::size_t v = 0; v < shell.positions.size(); ++v)
        largest = std::max(largest, length(mesh.positions[v] - shell.positions[v]));
    return largest;
}

// Before the local operations the flattest tets go, to this share of the height allowed: the rest of them is mostly
// mended by operations inside, which take nothing from the shape.
constexpr double first_share = 0.4;

// Nodes are added in runs: first those that gain so many bad tets more than their price, at last all that gain
// anything.
constexpr double node_levels[] = {4, 2, 1, 0.5, 0.25, 0, 0, 0};

// Between those runs tets up to so many times the angle of bad ones are mended, the rest only at the end.
constexpr double around_nodes = 2;

class Finisher {
public:
    Finisher(const SurfaceGuard& guard, const TetMesh& mesh, const Params& params, Report& report,
             const Context& context)
        : params_(params),
          report_(report),
          context_(context),
          guard_(guard),
          work_(mesh),
          budget_(std::uint64_t{params.budget} * mesh.tets.size()),
          node_budget_(budget_ * 3 / 8),
          volume_(params.peel_volume * report.before.volume) {}

    void merge_crowded() { report_.operations.contractions += merge_crowded_nodes(work_, guard_, context_); }

    // Only what hardly shows.
    void peel_flattest() { (void)peel({params_.peel_angle_deg, first_share * params_.peel_height, volume_}); }

    bool peel_flat() { return peel({params_.peel_angle_deg, params_.peel_height, volume_}); }

    void improve() {
        mend(params_.target_deg);
        if (params_.insert_below_deg > 0) add_nodes();
    }

    void raise_steps() {
        const StepReport raised =
            finish::raise_steps(work_, guard_, {params_.step_share, budget_ - report_.tried}, context_);
        report_.operations.step_changes = raised.changes;
        spend(raised.tried);
    }

    [[nodiscard]] TetMesh mesh() const { return take_mesh(work_); }

private:
    // The nodes that gain most come first: what is mended around them need not be paid for.
    void add_nodes() {
        NodeAdder adder(work_, {params_.insert_below_deg, params_.node_price});
        bool has_added = false;
        for (const double level : node_levels) {
            if (!add_nodes(adder, level)) continue;
            has_added = true;
            mend(std::min(params_.target_deg, around_nodes * params_.insert_below_deg));
        }
        if (has_added) mend(params_.target_deg);
    }

    bool add_nodes(NodeAdder& adder, double level) {
        const NodeReport added = adder.run(level, std::min(node_budget_, budget_ - report_.tried), context_);
        node_budget_ -= added.tried;
        report_.operations.insertions += added.added;
        report_.operations.reseats += added.reseated;
        report_.is_out_of_budget |= added.is_out_of_budget;
        spend(added.tried);
        return added.added + added.reseated > 0;
    }

    void mend(double target_deg) {
        const ImproveReport improved = improve_shapes(
            work_, guard_, {target_deg, params_.slide, params_.rounds, budget_ - report_.tried}, context_);
        Operations& sum = report_.operations;
        sum.edge_removals += improved.edge_removals;
        sum.surface_flips += improved.surface_flips;
        sum.face_removals += improved.face_removals;
        sum.moves += improved.moves;
        sum.contractions += improved.contractions;
        sum.slides += improved.slides;
        report_.is_out_of_budget |= improved.is_out_of_budget;
        report_.rounds_run += improved.rounds;
        spend(improved.tried);
    }

    void spend(std::uint64_t tried) {
        report_.tried += tried;
        report_.budget_used =
            report_.tried < budget_ ? static_cast<double>(report_.tried) / static_cast<double>(budget_) : 1;
    }

    void count(const PeelReport& peeled) {
        report_.peeled_tets += peeled.removed;
        report_.restored_tets += peeled.restored;
        volume_ -= peeled.spent;
    }

    bool peel(const PeelLimits& limits) {
        PeelReport peeled = clip_flaps(work_, guard_, limits, context_);
        count(peeled);
        PeelLimits rest = limits;
        rest.volume = volume_;
        const bool has_clipped = peeled.removed > 0;
        peeled = peel_flat_tets(work_, guard_, rest, context_);
        count(peeled);
        return has_clipped || peeled.removed > 0;
    }

    const Params& params_;
    Report& report_;
    const Context& context_;
    const SurfaceGuard& guard_;
    WorkMesh work_;
    std::uint64_t budget_;
    // Where most tets are bad, nodes would take it all and leave nothing to mend around them. A coarse mesh of a shell
    // full of needles wants a third.
    std::uint64_t node_budget_;
    double volume_;  // that may still be peeled off
};

}

// Local operations before the flat tets that show: many of those are mended, and then no volume is lost.
Result finish_mesh(const Shell& shell, TetMesh mesh, const Params& params, const Context& context) {
    check_input(shell, mesh);
    Result result;
    Report& report = result.report;
    report.before = quality::summarize(mesh, context);
    if (params.mode == Mode::none) {
        result.mesh = std::move(mesh);
        report.after = report.before;
        judge_result(shell, result.mesh, report, context);
        return result;
    }
    const SurfaceGuard guard(
        shell, {params.fold_deg, params.surface_gap, params.surface_gap_folded, params.surface_gap_diagonal});
    report.stripped_tets = strip_flat_tets(mesh, guard, context);
    repair(mesh, shell, report, context);
    Finisher finisher(guard, mesh, params, report, context);
    if (params.mode == Mode::full) {
        finisher.merge_crowded();
        finisher.peel_flattest();
        finisher.improve();
        if (finisher.peel_flat()) finisher.improve();
        finisher.raise_steps();
    } else {
        (void)finisher.peel_flat();
    }
    result.mesh = finisher.mesh();
    report.after = quality::summarize(result.mesh, context);
    report.largest_slide = largest_slide(shell, result.mesh);
    report.volume_change = report.before.volume > 0 ? report.after.volume / report.before.volume - 1 : 0;
    judge_result(shell, result.mesh, report, context);
    return result;
}

}
