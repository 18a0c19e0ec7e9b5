// SPDX-License-Identifier: GPL-3.0-or-later
#include "cull/cull.h"

#include <algorithm>
#include <cmath>

#include "cull/classify.h"
#include "cull/compact.h"
#include "cull/fidelity.h"
#include "cull/findings.h"
#include "cull/shell_solid.h"
#include "geometry/measures.h"
#include "geometry/predicates.h"
#include "mesh/boundary.h"

namespace crumple::cull {

namespace {

double volume_of(const TetMesh& mesh, Index t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    return signed_volume(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]);
}

void check_input(const Shell& shell, const TetMesh& mesh) {
    CRUMPLE_CHECK(mesh.shell_vertex_count == shell.positions.size(), "the mesh holds the shell's vertices");
    CRUMPLE_CHECK(mesh.positions.size() >= shell.positions.size(), "every shell vertex is a node");
    CRUMPLE_CHECK(std::equal(shell.positions.begin(), shell.positions.end(), mesh.positions.begin()),
                  "shell vertices are nodes at their index and place");
    for (const Tet& tet : mesh.tets) {
        for (const Index v : tet) CRUMPLE_CHECK(v < mesh.positions.size(), "every corner of a tet is a node");
        const auto& [a, b, c, d] = tet;
        CRUMPLE_CHECK(orient3d(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]) > 0,
                      "every tet is positive");
    }
}

std::vector<Index> regions_of(const std::vector<Verdict>& verdicts) {
    std::vector<Index> regions;
    regions.reserve(verdicts.size());
    for (const Verdict& verdict : verdicts) regions.push_back(verdict.region);
    return regions;
}

// Figures that need the tets that go as well as those that stay.
Report weigh(const TetMesh& mesh, const std::vector<Verdict>& verdicts, const ShellSolid& solid) {
    Report report;
    report.tets = mesh.tets.size();
    double estimated = 0;
    double undecided = 0;
    double considered = 0;
    for (Index t = 0; t < mesh.tets.size(); ++t) {
        const Verdict& verdict = verdicts[t];
        const double volume = volume_of(mesh, t);
        report.kept += verdict.region != none;
        report.straddling += verdict.straddles;
        if (verdict.region != none) report.volume += volume;
        estimated += volume * verdict.inside;
        if (verdict.winding >= 0.3) considered += volume;
        if (verdict.winding >= 0.3 && verdict.winding <= 0.7) undecided += volume;
    }
    report.leak_share = considered > 0 ? undecided / considered : 0;
    report.shell_volume_is_exact = solid.is_exact();
    report.shell_volume = solid.is_exact() ? solid.volume : estimated;
    if (report.shell_volume > 0)
        report.volume_error = std::fabs(report.volume - report.shell_volume) / report.shell_volume;
    return report;
}

void refuse_nothing(const Shell& shell, const Report& report) {
    if (report.kept > 0) return;
    std::string names;
    for (const Component& component : shell.components) {
        if (component.role != Role::cavity) names += (names.empty() ? "'" : ", '") + component.name + "'";
        if (names.size() > 120) break;
    }
    throw Error(
        ErrorKind::bad_input,
        "cull: none of " + std::to_string(report.tets) + " tets lies inside the shell (" +
            (names.empty() ? "every component is a cavity" : "components " + names) +
            "); close its holes, give single sheets a thickness, check that parts meant to be solid are not declared "
            "cavities, or lower min_inside");
}

void fill_regions(Report& report, const Shell& shell, const TetMesh& mesh, const std::vector<Index>& unused) {
    for (const Component& component : shell.components) report.regions.push_back({component.name, component.role});
    for (Index t = 0; t < mesh.tets.size(); ++t) {
        Region& region = report.regions[mesh.region[t]];
        ++region.tets;
        region.volume += volume_of(mesh, t);
    }
    const std::vector<Index> component = vertex_components(shell);
    for (const Index v : unused) ++report.regions[component[v]].unused_vertices;
}

void measure_result(Report& report, const Shell& shell, const ShellInterior& interior, const ShellSolid& solid,
                    const TetMesh& mesh, const Params& params, const Context& context) {
    const Boundary boundary = boundary_of(mesh);
    const NonManifold wrong = non_manifold(boundary.faces);
    const Fidelity fidelity =
        measure_fidelity(shell, interior, mesh.positions, boundary.faces, params.hausdorff_samples, context);
    const std::vector<Index> unused = unused_shell_vertices(shell, mesh);
    const std::vector<Index> pieces = pieces_of(mesh);
    report.nodes = mesh.positions.size();
    report.hausdorff_out = fidelity.diagonal > 0 ? fidelity.out.distance / fidelity.diagonal : 0;
    report.hausdorff_in = fidelity.diagonal > 0 ? fidelity.in.distance / fidelity.diagonal : 0;
    report.pieces = *std::max_element(pieces.begin(), pieces.end()) + 1;
    report.shell_pieces = solid.pieces;
    report.non_manifold_edges = wrong.edges.size();
    report.non_manifold_vertices = wrong.vertices.size();
    report.unused_shell_vertices = unused.size();
    fill_regions(report, shell, mesh, unused);
    report.findings = describe_findings(report, {shell, solid, fidelity, mesh, wrong, unused});
}

}

Result cull_outside(const Shell& shell, TetMesh mesh, const Params& params, const Context& context) {
    check_input(shell, mesh);
    const ShellInterior interior(shell);
    const ShellSolid solid = study_solid(shell, interior, context);
    context.tell_progress("telling inside from outside", 0);
    const std::vector<Verdict> verdicts = classify_tets(shell, interior, solid, mesh, params, context);

    Result result;
    result.report = weigh(mesh, verdicts, solid);
    refuse_nothing(shell, result.report);
    const std::size_t nodes = mesh.positions.size();
    result.mesh = compact(std::move(mesh), regions_of(verdicts));
    result.report.dropped_nodes = nodes - result.mesh.positions.size();
    context.tell_progress("measuring", 0.5);
    measure_result(result.report, shell, interior, solid, result.mesh, params, context);
    return result;
}

}
