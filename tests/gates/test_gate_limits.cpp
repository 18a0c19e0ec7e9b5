// SPDX-License-Identifier: GPL-3.0-or-later
// Every gate at its default: what passes, what is warned of, what fails.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <set>

#include "gates/baseline.h"
#include "gates/judge.h"
#include "mesh/neighbours.h"
#include "mesh/shapes.h"

using namespace crumple;
using namespace crumple::gates;
using quality::Figures;
using quality::measure;

namespace {

// What the table of gates says, in the recipe's names: the figure is allowed up to `warn` and is an error beyond
// `fail`.
struct Row {
    const char* gate;
    const char* code;
    double fail;
    double warn;
    Wanted wanted;
    // Makes a figure this bad.
    void (*set)(Figures&, double);
};

constexpr double a_million = 1e6;

std::uint32_t of_a_million(double share) { return static_cast<std::uint32_t>(std::llround(share * a_million)); }

// By hand: those of the quality study (its table of gates), then ours for what it wants told of leaks, embedding and
// baselines. A limit of `never` is none.
const Row rows[] = {
    {"min_dihedral_deg", "GATE_MIN_DIHEDRAL", 1, 5, Wanted::high,
     [](Figures& f, double x) { f.shape.min_dihedral_deg = x; }},
    {"max_dihedral_deg", "GATE_MAX_DIHEDRAL", 179, 170, Wanted::low,
     [](Figures& f, double x) { f.shape.max_dihedral_deg = x; }},
    {"below_10_share", "GATE_BELOW_10_DEG", 0.05, 0.005, Wanted::low,
     [](Figures& f, double x) {
         f.shape.below_10_deg = of_a_million(x) + 1000;
         f.below_10_thin = 1000;
     }},
    {"p5_dihedral_deg", "GATE_P5_DIHEDRAL", 5, 12, Wanted::high,
     [](Figures& f, double x) { f.shape.p5_dihedral_deg = x; }},
    {"volume_lrms3", "GATE_FLAT_TET", 0.001, 0.02, Wanted::high,
     [](Figures& f, double x) { f.shape.volume_lrms3_min = x; }},
    {"radius_ratio", "GATE_RADIUS_RATIO", 0.001, 0.01, Wanted::high,
     [](Figures& f, double x) { f.shape.radius_ratio_min = x; }},
    {"dt_ratio", "GATE_DT_RATIO", 0.01, 0.1, Wanted::high, [](Figures& f, double x) { f.cost.dt_ratio = x; }},
    {"stiffness_ratio", "GATE_STIFFNESS_RATIO", 10000, 500, Wanted::low,
     [](Figures& f, double x) { f.shape.stiffness_ratio = x; }},
    {"volume_error", "GATE_VOLUME", 0.05, 0.01, Wanted::low, [](Figures& f, double x) { f.fidelity.volume_error = x; }},
    {"volume_error", "GATE_VOLUME", 0.05, 0.01, Wanted::low,
     [](Figures& f, double x) { f.fidelity.volume_error = -x; }},
    {"hausdorff", "GATE_HAUSDORFF_OUT", 0.05, 0.015, Wanted::low,
     [](Figures& f, double x) { f.fidelity.hausdorff_out = x; }},
    {"hausdorff", "GATE_HAUSDORFF_IN", 0.05, 0.015, Wanted::low,
     [](Figures& f, double x) { f.fidelity.hausdorff_in = x; }},
    {"non_manifold", "GATE_NON_MANIFOLD", never, 0, Wanted::low,
     [](Figures& f, double x) { f.topology.non_manifold_edges = static_cast<std::uint64_t>(std::ceil(x)); }},
    {"non_manifold", "GATE_NON_MANIFOLD", never, 0, Wanted::low,
     [](Figures& f, double x) { f.topology.non_manifold_vertices = static_cast<std::uint64_t>(std::ceil(x)); }},
    {"extra_pieces", "GATE_PIECES", 0, 0, Wanted::low,
     [](Figures& f, double x) {
         f.topology.shell_pieces = x > 0 ? 1 : 2;  // of two there are
     }},
    {"leak_share", "GATE_LEAK", 0.1, 0.02, Wanted::low, [](Figures& f, double x) { f.fidelity.leak_share = x; }},
    {"outside_share", "GATE_OUTSIDE", never, 0.01, Wanted::low,
     [](Figures& f, double x) {
         f.embedding.vertices = of_a_million(1);
         f.embedding.outside = x < 1 ? of_a_million(x) : of_a_million(1);
     }},
    {"max_weight", "GATE_MAX_WEIGHT", never, 1.5, Wanted::low,
     [](Figures& f, double x) {
         f.embedding.vertices = 1;
         f.embedding.max_weight = x;
     }},
    {"bound_wrongly", "GATE_BOUND_WRONGLY", never, 0, Wanted::low,
     [](Figures& f, double x) {
         f.embedding.vertices = of_a_million(1);
         f.embedding.bound_wrongly = static_cast<std::uint64_t>(std::ceil(x));
     }},
};

// Against a baseline of a million of each.
const Row baseline_rows[] = {
    {"pcg_growth", "GATE_PCG_SOFT", 1.5, 1.15, Wanted::low,
     [](Figures& f, double x) { f.cost.pcg_soft = of_a_million(x); }},
    {"pcg_growth", "GATE_PCG_STIFF", 1.5, 1.15, Wanted::low,
     [](Figures& f, double x) { f.cost.pcg_stiff = of_a_million(x); }},
    {"tets_growth", "GATE_TETS", never, 1.25, Wanted::low,
     [](Figures& f, double x) { f.shape.tets = of_a_million(x < 4000 ? x : 4000); }},
    {"volume_change", "GATE_VOLUME_CHANGED", 0.05, 0.01, Wanted::low,
     [](Figures& f, double x) { f.shape.volume = a_million + std::round(x * a_million); }},
    {"volume_change", "GATE_VOLUME_CHANGED", 0.05, 0.01, Wanted::low,
     [](Figures& f, double x) { f.shape.volume = a_million - std::round(x * a_million); }},
};

// The least that is worse, for shares of a million too.
double just_beyond(const Row& row, double limit) {
    const double least = 1 / a_million;
    return row.wanted == Wanted::high ? limit - least : limit + least;
}

// Far beyond what any mesh can be.
double far_beyond(const Row& row) { return row.wanted == Wanted::high ? 0 : never / 10; }

TetMesh two_cubes() {
    TetMesh mesh = shapes::tet_grid(2);
    const TetMesh other = shapes::tet_grid(2, {2, 0, 0}, {3, 1, 1});
    const auto first = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    for (const auto& [a, b, c, d] : other.tets) mesh.tets.push_back({first + a, first + b, first + c, first + d});
    mesh.neighbours = neighbours_of(mesh.tets);
    return mesh;
}

using Judge = std::function<std::vector<Finding>(const Row&, double)>;

void expect_verdict(const Row& row, double figure, const Judge& judge_figure, std::optional<Severity> severity) {
    SCOPED_TRACE(std::string(row.code) + " at " + std::to_string(figure));
    const std::vector<Finding> findings = judge_figure(row, figure);
    ASSERT_EQ(findings.size(), severity ? 1u : 0u);
    if (!severity) return;
    EXPECT_EQ(findings[0].code, row.code);
    EXPECT_EQ(findings[0].severity, *severity);
    EXPECT_NE(findings[0].message.find("; "), std::string::npos) << "what to try";
}

void expect_limits(const Row& row, const Judge& judge_figure) {
    expect_verdict(row, row.warn, judge_figure, std::nullopt);
    const bool can_warn = row.fail != row.warn;
    const bool can_fail = row.fail != never;
    if (can_warn) expect_verdict(row, just_beyond(row, row.warn), judge_figure, Severity::warning);
    if (can_warn && can_fail) expect_verdict(row, row.fail, judge_figure, Severity::warning);
    if (can_fail) expect_verdict(row, just_beyond(row, row.fail), judge_figure, Severity::error);
    if (!can_fail) expect_verdict(row, far_beyond(row), judge_figure, Severity::warning);
}

TEST(GateLimits, EachPassesWarnsAndFailsAtItsDefault) {
    const TetMesh mesh = two_cubes();
    Figures good = measure(mesh, nullptr);
    good.shape.tets = of_a_million(1);
    good.fidelity.is_known = good.fidelity.is_closed = true;
    const Judge judge_figure = [&](const Row& row, double figure) {
        Figures figures = good;
        row.set(figures, figure);
        return judge(figures, mesh, nullptr);
    };
    for (const Row& row : rows) expect_limits(row, judge_figure);
}

TEST(GateLimits, EachOfABaselinePassesWarnsAndFailsAtItsDefault) {
    const Baseline baseline{of_a_million(1), a_million, of_a_million(1), of_a_million(1)};
    const Judge judge_figure = [&](const Row& row, double figure) {
        Figures figures;
        figures.shape.tets = of_a_million(1);
        figures.shape.volume = a_million;
        figures.cost.pcg_soft = figures.cost.pcg_stiff = of_a_million(1);
        row.set(figures, figure);
        return judge_against(baseline, figures);
    };
    for (const Row& row : baseline_rows) expect_limits(row, judge_figure);
}

struct GateNames {
    std::set<std::string> names;
    void field(const char* name, const Gate&, const char*) { names.insert(name); }
};

TEST(GateLimits, TheTablesKnowThemAll) {
    GateNames described;
    const Limits params;
    describe(described, params);
    std::set<std::string> tested;
    for (const Row& row : rows) tested.insert(row.gate);
    for (const Row& row : baseline_rows) tested.insert(row.gate);
    EXPECT_EQ(tested, described.names);
}

}
