// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/recover.h"

#include <algorithm>

#include "geometry/predicates.h"
#include "recover/canonical.h"
#include "recover/findings.h"
#include "recover/recovery.h"

namespace crumple::recover {

namespace {

void check_input(const TetMesh& mesh, const Shell& shell) {
    if (!mesh.region.empty()) {
        throw Error(ErrorKind::bad_input,
                    "recover: the tets were culled already; run recover on the tets of delaunay or relax");
    }
    CRUMPLE_CHECK(mesh.neighbours.size() == mesh.tets.size(), "tets know their neighbours");
    CRUMPLE_CHECK(mesh.shell_vertex_count == shell.positions.size(), "the mesh holds the shell's vertices");
    CRUMPLE_CHECK(mesh.positions.size() >= shell.positions.size() &&
                      std::equal(shell.positions.begin(), shell.positions.end(), mesh.positions.begin()),
                  "shell vertices are nodes at their index and place");
    for (const Tet& tet : mesh.tets) {
        for (const Index v : tet) CRUMPLE_CHECK(v < mesh.positions.size(), "every corner of a tet is a node");
        const auto& [a, b, c, d] = tet;
        CRUMPLE_CHECK(orient3d(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]) > 0,
                      "every tet is positive");
    }
}

void report_missing(Report& report, const Missing<Edge>& edges, const Missing<Triangle>& triangles) {
    report.missing_edges = edges.count();
    report.missing_triangles = triangles.count();
    report.negligible_edges = edges.negligible.size();
    report.negligible_triangles = triangles.negligible.size();
    report.blocked_edges = edges.blocked.size();
    report.blocked_triangles = triangles.blocked.size();
}

}

Result recover_shell(TetMesh mesh, const Shell& shell, const Params& params, const Context& context) {
    if (params.mode == Mode::off) return {std::move(mesh), {}};
    check_input(mesh, shell);
    Canonical task = canonical_task(mesh, shell);
    TetComplex complex(task.mesh);
    Recovery recovery(complex, task.constraints, params, context);

    Report report;
    report.edges = task.constraints.segments().size();
    report.triangles = task.constraints.facets().size();
    report.missing_edges_before = recovery.missing_segments().size();
    report.missing_triangles_before = recovery.missing_facets().size();
    recovery.run();

    const Missing<Edge> edges = recovery.judge_segments();
    const Missing<Triangle> triangles = recovery.judge_facets(edges);
    report_missing(report, edges, triangles);
    report.exchanges = recovery.exchanges();
    report.looks = recovery.looks();
    report.is_out_of_budget = recovery.is_out_of_budget();
    report.steiner_points_tried = recovery.splits_tried();
    report.steiner_points = recovery.splits().size();
    report.findings = describe_findings({shell, complex, task.constraints, recovery.splits(), edges, triangles});
    TetMesh recovered = original_mesh(task, complex.to_mesh(), mesh);
    report.added_nodes = recovered.positions.size() - mesh.positions.size();
    return {std::move(recovered), std::move(report)};
}

}
