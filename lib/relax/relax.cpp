// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/relax.h"

#include <algorithm>
#include <string>

#include "core/parallel_for.h"
#include "delaunay/delaunay.h"
#include "mesh/shell_interior.h"
#include "relax/inside_tets.h"
#include "relax/method.h"
#include "relax/move_nodes.h"
#include "relax/stars.h"

namespace crumple::relax {

namespace {

// A mesh with what has to be known to sweep over it and to compare it with others.
struct Iterate {
    TetMesh mesh;
    std::vector<std::uint8_t> is_inside;  // T
    std::vector<Tet> inside;              // the tets of those
    quality::Score score;
};

void check_input(const TetMesh& mesh, const Shell& shell) {
    CRUMPLE_CHECK(mesh.shell_vertex_count == shell.positions.size(), "relax needs the shell its mesh was made of");
    CRUMPLE_CHECK(mesh.positions.size() >= shell.positions.size(), "a mesh holds its shell's vertices");
    CRUMPLE_CHECK(std::equal(shell.positions.begin(), shell.positions.end(), mesh.positions.begin()),
                  "shell vertices come first, at their place");
}

TargetFunction target_function(Method method) {
    for (const MethodEntry& entry : methods) {
        if (entry.method == method) return entry.target;
    }
    throw Error(ErrorKind::internal, "internal: an unknown relax method");
}

std::vector<Index> materials_of(const TetMesh& mesh, const ShellInterior& interior) {
    std::vector<Index> materials;
    for (std::size_t v = mesh.shell_vertex_count; v < mesh.positions.size(); ++v) {
        materials.push_back(interior.material_at(mesh.positions[v]));
    }
    return materials;
}

Iterate judge(TetMesh mesh, InsideTets& inside_tets, const Context& context) {
    Iterate iterate;
    iterate.is_inside = inside_tets.find(mesh, context);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        if (iterate.is_inside[t]) iterate.inside.push_back(mesh.tets[t]);
    }
    iterate.score = quality::score_of(mesh.positions, iterate.inside, context);
    iterate.mesh = std::move(mesh);
    return iterate;
}

TetMesh triangulate(const TetMesh& old, const std::vector<Vec3>& places, const Context& context) {
    PointSet points{old.positions, old.shell_vertex_count};
    std::copy(places.begin(), places.end(), points.positions.begin() + old.shell_vertex_count);
    return delaunay::tetrahedralize(points, {}, context).mesh;
}

SweepReport report_of(std::int32_t sweep, const Moves& moves, const quality::Score& score) {
    return {sweep,
            moves.max_move,
            moves.held,
            score.below_10_deg,
            quality::degrees_of(score.p1_dihedral),
            quality::degrees_of(score.p5_dihedral),
            quality::degrees_of(score.median_dihedral)};
}

void report_outside_nodes(Report& report, const TetMesh& mesh, const std::vector<Index>& materials) {
    Finding finding{"RELAX_NODE_OUTSIDE",
                    Severity::warning,
                    "interior nodes lie in no material; they stay where they are and culling will drop them",
                    0,
                    {}};
    for (std::size_t n = 0; n < materials.size(); ++n) {
        const Index node = mesh.shell_vertex_count + static_cast<Index>(n);
        if (materials[n] == none) count_one(finding, {mesh.positions[node], node, {}});
    }
    if (finding.count > 0) report.findings.push_back(finding);
}

void report_shell_slivers(Report& report, const Iterate& best) {
    std::vector<Tet> of_shell;
    for (const Tet& tet : best.inside) {
        if (std::all_of(tet.begin(), tet.end(), [&](Index v) { return v < best.mesh.shell_vertex_count; }))
            of_shell.push_back(tet);
    }
    report.shell_only_below_10_deg = quality::score_of(best.mesh.positions, of_shell).below_10_deg;
    if (report.shell_only_below_10_deg == 0) return;
    std::vector<Place> worst = quality::worst_tets(best.mesh.positions, of_shell);
    for (Place& place : worst) place.element = none;
    report.findings.push_back({"RELAX_SHELL_SLIVERS", Severity::info,
                               "flat tets whose four nodes are shell vertices: moving interior nodes cannot mend them",
                               report.shell_only_below_10_deg, std::move(worst)});
}

void finish_report(Report& report, const Iterate& best, const Context& context) {
    report.after =
        report.best_sweep == 0 ? report.before : quality::summarize(best.mesh.positions, best.inside, context);
    report_shell_slivers(report, best);
}

}

Result relax_points(TetMesh mesh, const Shell& shell, const Params& params, const Context& context) {
    check_input(mesh, shell);
    const TargetFunction target = target_function(params.method);
    const ShellInterior interior(shell);
    InsideTets inside_tets(interior);
    const std::vector<Index> materials = materials_of(mesh, interior);  // for good: no node leaves its own
    Iterate now = judge(std::move(mesh), inside_tets, context);

    Report report;
    report.interior_nodes = static_cast<std::uint32_t>(materials.size());
    report.before = quality::summarize(now.mesh.positions, now.inside, context);
    report.history.push_back(report_of(0, {}, now.score));
    report_outside_nodes(report, now.mesh, materials);
    Iterate best = now;
    while (report.sweeps_run < params.sweeps && !report.converged) {
        context.stop_if_cancelled();
        context.tell_progress("relax", static_cast<double>(report.sweeps_run) / params.sweeps);
        const Stars stars = find_stars(now.mesh, now.is_inside);
        const Moves moves = choose_moves(now.mesh, stars, materials, target, interior, context);
        report.converged = moves.max_move <= params.tolerance;
        if (moves.max_move == 0) break;
        now = judge(triangulate(now.mesh, moves.places, context), inside_tets, context);
        report.history.push_back(report_of(++report.sweeps_run, moves, now.score));
        if (quality::is_better(now.score, best.score)) {
            best = now;
            report.best_sweep = report.sweeps_run;
        }
    }
    finish_report(report, best, context);
    return {std::move(best.mesh), std::move(report)};
}

}
