// SPDX-License-Identifier: GPL-3.0-or-later
// Brings the shell's edges and triangles back into tets that hold its vertices: first by exchanging a few tets for
// others [George, Hecht, Saltel 1991; Si 2015], then by nodes on the shell that leave it again for its inside [George,
// Borouchaki, Saltel 2003]. Afterwards the tets are Delaunay no more, but each lies on one side of the shell.
// Shell vertices never move and keep their index.
#pragma once
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"

namespace crumple::recover {

inline constexpr int version = 2;

enum class Mode { off, automatic, always };
inline constexpr EnumName<Mode> mode_names[] = {
    {Mode::off, "off"}, {Mode::automatic, "auto"}, {Mode::always, "always"}};
constexpr std::span<const EnumName<Mode>> enum_names(Mode) { return mode_names; }

struct Params {
    Mode mode = Mode::automatic;
    std::uint32_t depth = 2;
    double max_steiner = 0.1;
    double negligible = 0.02;
    std::uint32_t budget = 50;
};

template <class Visitor, FieldsOf<Params> P>
void describe(Visitor& visit, P& p) {
    visit.field("mode", p.mode,
                "off: leave the tets as they are; auto: bring back what changes the shape by more than `negligible`; "
                "always: bring all back that faces of the tets do not cover exactly");
    visit.field("depth", p.depth, Range{0, 6}, "edges that may be exchanged to make room for exchanging another one");
    visit.field("max_steiner", p.max_steiner, Range{0, 10},
                "nodes that may be on the shell's edges and triangles at one time where nothing else helps, in shell "
                "vertices, and four more; nearly all leave again");
    visit.field(
        "negligible", p.negligible, Range{0, 0.1},
        "auto: a missing edge of less than 5 degrees fold is no loss when the tets' own faces pass this near to it, "
        "in lengths of it (and nearer than 0.1 % of the shell's diagonal)");
    visit.field("budget", p.budget, Range{0, 1e6},
                "looks at what is in the way, for each of the shell's edges and triangles, on average, at most: a "
                "shell needs 0 to 5, one that lies across itself as many as it gets");
}

// Of the shell's edges and triangles, copies counted once.
struct Report {
    std::uint64_t edges = 0;
    std::uint64_t triangles = 0;
    std::uint64_t missing_edges_before = 0;
    std::uint64_t missing_triangles_before = 0;
    std::uint64_t missing_edges = 0;
    std::uint64_t missing_triangles = 0;
    std::uint64_t negligible_edges = 0;
    std::uint64_t negligible_triangles = 0;
    std::uint64_t exchanges = 0;
    std::uint64_t looks = 0;
    bool is_out_of_budget = false;
    std::uint64_t steiner_points_tried = 0;
    std::uint64_t steiner_points = 0;
    std::uint64_t added_nodes = 0;
    std::uint64_t blocked_edges = 0;
    std::uint64_t blocked_triangles = 0;
    std::vector<Finding> findings;  // RECOVER_*
};

template <class Visitor, FieldsOf<Report> R>
void describe(Visitor& visit, R& r) {
    visit.field("edges", r.edges, "of the shell");
    visit.field("triangles", r.triangles, "of the shell");
    visit.field("missing_edges_before", r.missing_edges_before, "of them not edges of the tets, as they came");
    visit.field("missing_triangles_before", r.missing_triangles_before, "of them not faces of the tets, as they came");
    visit.field("missing_edges", r.missing_edges, "still not edges of the tets");
    visit.field("missing_triangles", r.missing_triangles, "still not faces of the tets");
    visit.field("negligible_edges", r.negligible_edges, "of those, where the tets' own edges run next to them");
    visit.field("negligible_triangles", r.negligible_triangles, "of those, where the tets' own faces cover them");
    visit.field("exchanges", r.exchanges, "of a few tets for others");
    visit.field("looks", r.looks, "at edges of the tets that were in the way, and at what was in their way");
    visit.field("is_out_of_budget", r.is_out_of_budget, "whether those were all that `budget` allows");
    visit.field("steiner_points_tried", r.steiner_points_tried, "nodes put on edges and triangles of the shell");
    visit.field("steiner_points", r.steiner_points, "of those, that had to stay");
    visit.field("added_nodes", r.added_nodes, "nodes more than before, those included");
    visit.field("blocked_edges", r.blocked_edges, "edges missing because other parts of the shell run through them");
    visit.field("blocked_triangles", r.blocked_triangles,
                "triangles missing because other parts of the shell run through them");
    visit.field("findings", r.findings, "what a person should know");
}

struct Result {
    TetMesh mesh;  // of the same convex hull; nodes keep their index, added ones follow
    Report report;
};

// The order of triangles, vertices and tets in the input does not matter to what is done, only to how it is numbered.
// REQUIRES: mesh fills the shell's convex hull, every tet positive, and holds every place of a shell vertex; the
// shell's vertices are its first nodes.
[[nodiscard]] Result recover_shell(TetMesh mesh, const Shell& shell, const Params& params = {},
                                   const Context& context = {});

}
