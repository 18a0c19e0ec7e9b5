// SPDX-License-Identifier: GPL-3.0-or-later
// Gives the tets inside the shell shapes worth simulating, without moving the artist's vertices: repairs the surface
// where it touches itself, peels flat tets off it, mends bad tets by local operations and raises the time step of the
// few nodes that would set it. The result is no longer Delaunay.
#pragma once
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"
#include "quality/quality.h"

namespace crumple::finish {

inline constexpr int version = 6;

enum class Mode { none, peel, full };
inline constexpr EnumName<Mode> mode_names[] = {{Mode::none, "none"}, {Mode::peel, "peel"}, {Mode::full, "full"}};
constexpr std::span<const EnumName<Mode>> enum_names(Mode) { return mode_names; }

struct Params {
    Mode mode = Mode::full;
    double peel_angle_deg = 12;
    double peel_height = 0.05;
    double peel_volume = 0.005;
    double fold_deg = 0.5;
    double surface_gap = 0.01;
    double surface_gap_folded = 0.003;
    double surface_gap_diagonal = 1e-3;
    double target_deg = 40;
    double insert_below_deg = 10;
    double node_price = 0.5;
    double step_share = 0.35;
    double slide = 0;
    std::uint32_t rounds = 10;
    std::uint32_t budget = 400;
};

template <class Visitor, FieldsOf<Params> P>
void describe(Visitor& visit, P& p) {
    visit.field("mode", p.mode,
                "none, peel (flat tets at the surface go) or full (peel, then local operations on bad tets)");
    visit.field("peel_angle_deg", p.peel_angle_deg, Range{0, 45}, "a tet with an angle below this may be peeled off");
    visit.field("peel_height", p.peel_height, Range{0, 0.5}, "when it is flatter than this times its mean edge");
    visit.field("peel_volume", p.peel_volume, Range{0, 0.1}, "share of the volume that may be peeled off in all");
    visit.field("fold_deg", p.fold_deg, Range{0, 30},
                "an edge of the surface may flip when its two faces are flat to this angle, before and after");
    visit.field("surface_gap", p.surface_gap, Range{0, 0.2},
                "and when the surface moves by no more than this times the edges there");
    visit.field("surface_gap_folded", p.surface_gap_folded, Range{0, 0.2},
                "the same at a larger fold, up to 30 degrees: a triangle flatter than this is as good as none");
    visit.field("surface_gap_diagonal", p.surface_gap_diagonal, Range{0, 0.05},
                "nor by more than this times the shell's diagonal");
    visit.field("target_deg", p.target_deg, Range{0, 60}, "tets as good as this smallest angle are left alone");
    visit.field("insert_below_deg", p.insert_below_deg, Range{0, 60},
                "tets worse than this may get a node in their midst");
    visit.field("node_price", p.node_price, Range{0, 100},
                "when so many fewer of them are left then: the more, the fewer nodes are added");
    visit.field("step_share", p.step_share, Range{0, 1},
                "nodes that alone would allow less than this share of the median time step are relieved, the worst "
                "first: they set the step of an explicit simulation; 0: none");
    visit.field(
        "slide", p.slide, Range{0, 0.5},
        "how far an unlocked shell vertex on a smooth part may slide along it, in its shortest edges; 0: no shell "
        "vertex ever moves");
    visit.field("rounds", p.rounds, Range{0, 1000}, "over all bad tets whose surroundings changed, at most");
    visit.field("budget", p.budget, Range{0, 1e6}, "operations tried for each tet, on average, at most");
}

struct Operations {
    std::uint64_t edge_removals = 0;
    std::uint64_t surface_flips = 0;
    std::uint64_t face_removals = 0;
    std::uint64_t moves = 0;
    std::uint64_t contractions = 0;
    std::uint64_t insertions = 0;
    std::uint64_t reseats = 0;
    std::uint64_t slides = 0;
    std::uint64_t step_changes = 0;
};

template <class Visitor, FieldsOf<Operations> P>
void describe(Visitor& visit, P& p) {
    visit.field("edge_removals", p.edge_removals, "edges inside taken out, the space around them filled anew");
    visit.field("surface_flips", p.surface_flips, "the same at edges of the surface");
    visit.field("face_removals", p.face_removals, "faces taken out and the nodes beside them joined by an edge");
    visit.field("moves", p.moves, "steps of interior nodes");
    visit.field("contractions", p.contractions, "interior nodes merged into a neighbour");
    visit.field("insertions", p.insertions, "interior nodes added");
    visit.field("reseats", p.reseats, "interior nodes taken out and put in again elsewhere");
    visit.field("slides", p.slides, "steps of shell vertices");
    visit.field("step_changes", p.step_changes, "changes of any kind that raised the smallest time step");
}

struct Repair {
    std::uint64_t edges_before = 0;
    std::uint64_t nodes_before = 0;
    std::uint64_t nodes_left = 0;
    std::uint64_t removed = 0;
    std::uint64_t added = 0;
    std::uint64_t split = 0;
    std::uint64_t bent = 0;
    std::uint64_t cut = 0;
    double volume_removed = 0;
    double volume_added = 0;
};

template <class Visitor, FieldsOf<Repair> P>
void describe(Visitor& visit, P& p) {
    visit.field("edges_before", p.edges_before, "edges of the surface where other than two faces met");
    visit.field("nodes_before", p.nodes_before, "nodes where the surface touched itself");
    visit.field("nodes_left", p.nodes_left, "nodes where it still does");
    visit.field("removed", p.removed, "tets taken away to part it");
    visit.field("added", p.added, "tets added to join it");
    visit.field("split", p.split, "nodes copied, so that parts no longer touch there");
    visit.field("bent", p.bent, "edges that parts were bent off, each by a new node");
    visit.field("cut", p.cut, "nodes whose tets were cut down to one tip, by new nodes below");
    visit.field("volume_removed", p.volume_removed, "cubic metres taken away by all of this");
    visit.field("volume_added", p.volume_added, "cubic metres added");
}

struct Report {
    quality::Summary before;
    quality::Summary after;
    std::uint64_t stripped_tets = 0;
    Repair repair;
    std::uint64_t peeled_tets = 0;
    std::uint64_t restored_tets = 0;
    double volume_change = 0;
    double largest_slide = 0;
    Operations operations;
    std::uint32_t rounds_run = 0;
    std::uint64_t tried = 0;
    double budget_used = 0;
    bool is_out_of_budget = false;
    std::uint64_t forced_thin = 0;
    std::uint64_t forced_needle = 0;
    std::uint64_t forced_gap = 0;
    std::uint64_t failed = 0;
    // FINISH_BAD_TETS, FINISH_FORCED_THIN, FINISH_FORCED_NEEDLE, FINISH_FORCED_GAP, FINISH_REPAIRED,
    // FINISH_NON_MANIFOLD, FINISH_BUDGET
    std::vector<Finding> findings;
};

template <class Visitor, FieldsOf<Report> P>
void describe(Visitor& visit, P& p) {
    visit.field("before", p.before, "shapes as they came");
    visit.field("after", p.after, "shapes of the result");
    visit.field("stripped_tets", p.stripped_tets, "tets without thickness taken off the surface");
    visit.field("repair", p.repair, "what made the surface a manifold");
    visit.field("peeled_tets", p.peeled_tets, "flat tets taken off the surface");
    visit.field("restored_tets", p.restored_tets, "of those, tets that lay outside the shell's own triangles");
    visit.field("volume_change", p.volume_change, "volume now over volume before, less 1");
    visit.field("largest_slide", p.largest_slide, "metres, the farthest a shell vertex went");
    visit.field("operations", p.operations, "what was done");
    visit.field("rounds_run", p.rounds_run, "over all bad tets whose surroundings changed");
    visit.field("tried", p.tried, "operations tried, whether they led to a change or not");
    visit.field("budget_used", p.budget_used, "share of the operations allowed");
    visit.field("is_out_of_budget", p.is_out_of_budget, "stopped because that was all");
    visit.field("forced_thin", p.forced_thin, "tets left below 10 degrees because the shell is thin there");
    visit.field("forced_needle", p.forced_needle, "tets left below 10 degrees because the shell has a needle there");
    visit.field("forced_gap", p.forced_gap,
                "tets left below 10 degrees because two surfaces of the shell nearly meet there");
    visit.field("failed", p.failed, "tets left below 10 degrees that the shell does not force");
    visit.field("findings", p.findings, "what a person should know");
}

struct Result {
    TetMesh mesh;  // shell vertices at their index and, without slide, their place; interior nodes moved, dropped and
                   // added at the end
    Report report;
};

// REQUIRES: mesh after cull: regions and neighbours filled, every tet positive, the shell's vertices first.
[[nodiscard]] Result finish_mesh(const Shell& shell, TetMesh mesh, const Params& params = {},
                                 const Context& context = {});

}
