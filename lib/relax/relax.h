// SPDX-License-Identifier: GPL-3.0-or-later
// Moves interior nodes and triangulates again until the shapes are good. Shell vertices never move.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"
#include "quality/quality.h"

namespace crumple::relax {

inline constexpr int version = 1;

// Where a node moves to; each is explained in method_<name>.cpp.
enum class Method { cpt, odt, lloyd };
inline constexpr EnumName<Method> method_names[] = {
    {Method::cpt, "cpt"}, {Method::odt, "odt"}, {Method::lloyd, "lloyd"}};
constexpr std::span<const EnumName<Method>> enum_names(Method) { return method_names; }

struct Params {
    Method method = Method::cpt;
    std::int32_t sweeps = 20;
    double tolerance = 1e-3;
};

// Of the tets inside the shell after a sweep; sweep 0 is the mesh as it came.
struct SweepReport {
    std::int32_t sweep = 0;
    double max_move = 0;             // farthest any node went, in mean edges at the node
    std::uint32_t held = 0;          // nodes that took a shorter step or none, to stay in their material
    std::uint32_t below_10_deg = 0;  // tets
    double p1_dihedral_deg = 0;
    double p5_dihedral_deg = 0;
    double median_dihedral_deg = 0;
};

struct Report {
    std::uint32_t interior_nodes = 0;
    std::int32_t sweeps_run = 0;
    std::int32_t best_sweep = 0;                // whose mesh is the result
    bool converged = false;                     // stopped because nothing moved any more
    std::uint32_t shell_only_below_10_deg = 0;  // tets of the result that hang on shell vertices alone
    quality::Summary before;                    // of the tets inside the shell
    quality::Summary after;
    std::vector<SweepReport> history;
    std::vector<Finding> findings;  // RELAX_SHELL_SLIVERS, RELAX_NODE_OUTSIDE
};

template <class Visitor, FieldsOf<Params> P>
void describe(Visitor& visit, P& p) {
    visit.field(
        "method", p.method,
        "where a node moves to: cpt (middle of its tets), odt (optimal Delaunay), lloyd (middle of its Voronoi cell)");
    visit.field("sweeps", p.sweeps, Range{0, 1000}, "passes of moving all nodes and triangulating again, at most");
    visit.field("tolerance", p.tolerance, Range{0, 1},
                "stop when no node moves farther than this times the mean edge at it");
}

template <class Visitor, FieldsOf<SweepReport> S>
void describe(Visitor& visit, S& s) {
    visit.field("sweep", s.sweep, "0 is the mesh as it came");
    visit.field("max_move", s.max_move, "farthest any node went, in mean edges at the node");
    visit.field("held", s.held, "nodes that took a shorter step or none, to stay in their material");
    visit.field("below_10_deg", s.below_10_deg, "tets inside with an angle below 10 degrees");
    visit.field("p1_dihedral_deg", s.p1_dihedral_deg, "1st percentile of the tets' smallest dihedral angles");
    visit.field("p5_dihedral_deg", s.p5_dihedral_deg, "5th percentile");
    visit.field("median_dihedral_deg", s.median_dihedral_deg, "median");
}

template <class Visitor, FieldsOf<Report> R>
void describe(Visitor& visit, R& r) {
    visit.field("interior_nodes", r.interior_nodes, "nodes that may move");
    visit.field("sweeps_run", r.sweeps_run, "sweeps made");
    visit.field("best_sweep", r.best_sweep,
                "the sweep whose mesh was kept: fewest tets below 10 degrees, then best 1st percentile");
    visit.field("converged", r.converged, "stopped because nothing moved any more");
    visit.field("shell_only_below_10_deg", r.shell_only_below_10_deg,
                "tets below 10 degrees that hang on shell vertices alone");
    visit.field("before", r.before, "shapes of the tets inside, as they came");
    visit.field("after", r.after, "shapes of the tets inside, relaxed");
    visit.field("history", r.history, "sweep by sweep");
    visit.field("findings", r.findings, "what a person should know");
}

struct Result {
    TetMesh
        mesh;  // Delaunay of the moved nodes, whole convex hull; nodes keep their index and stay float-representable
    Report report;
};

// No node leaves the material it lies in, and no two come to lie on one place.
// REQUIRES: mesh is the Delaunay tetrahedralization of its nodes, the shell's vertices first and at their place.
[[nodiscard]] Result relax_points(TetMesh mesh, const Shell& shell, const Params& params = {},
                                  const Context& context = {});

}
