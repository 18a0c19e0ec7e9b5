// SPDX-License-Identifier: GPL-3.0-or-later
#include "cull/findings.h"

#include <algorithm>

#include "core/short_text.h"

namespace crumple::cull {

namespace {

// Where a person should look twice; the figures are design goals for car bodies, not limits of the method.
constexpr double noticeable_volume_error = 0.01;
constexpr double noticeable_stray = 0.015;
constexpr double noticeable_leak = 0.02;

Finding warning(std::string code, std::uint64_t count, std::string message) {
    return {std::move(code), Severity::warning, std::move(message), count, {}};
}

void report_shape(std::vector<Finding>& findings, const Report& report, const Evidence& evidence) {
    if (report.volume_error > noticeable_volume_error) {
        findings.push_back(
            warning("CULL_VOLUME", 1,
                    "the tets hold " + percent_text(report.volume / report.shell_volume) +
                        " of the solid's volume: triangles of the shell are missing from the tets; use finer "
                        "triangles where the shell is thin"));
    }
    const auto stray = [&](const char* code, double share, const Farthest& farthest, const std::string& what) {
        if (!(share > noticeable_stray)) return;
        Finding finding =
            warning(code, 1, what + " by up to " + percent_text(share) + " of the diagonal; use finer triangles there");
        finding.places.push_back({farthest.sample.position, none, {}});
        findings.push_back(std::move(finding));
    };
    stray("CULL_STRAY_OUT", report.hausdorff_out, evidence.fidelity.out, "the surface of the tets leaves the shell");
    stray("CULL_STRAY_IN", report.hausdorff_in, evidence.fidelity.in, "the tets miss parts of the shell");
}

void report_topology(std::vector<Finding>& findings, const Report& report, const Evidence& evidence) {
    if (report.pieces > report.shell_pieces) {
        findings.push_back(warning("CULL_PIECES", report.pieces,
                                   "the tets fall into " + std::to_string(report.pieces) + " pieces, the solid has " +
                                       std::to_string(report.shell_pieces) +
                                       ": the shell is thin or its edges long there"));
    }
    if (!evidence.non_manifold.edges.empty()) {
        Finding finding =
            warning("CULL_NON_MANIFOLD_EDGES", 0, "edges where more than two faces of the tets' surface meet");
        for (const Edge& edge : evidence.non_manifold.edges) {
            const Vec3 middle = (evidence.mesh.positions[edge[0]] + evidence.mesh.positions[edge[1]]) * 0.5;
            count_one(finding, {middle, edge[0], {}});
        }
        findings.push_back(std::move(finding));
    }
    if (!evidence.non_manifold.vertices.empty()) {
        Finding finding = warning("CULL_NON_MANIFOLD_VERTICES", 0, "nodes where the tets' surface touches itself");
        for (const Index v : evidence.non_manifold.vertices) count_one(finding, {evidence.mesh.positions[v], v, {}});
        findings.push_back(std::move(finding));
    }
}

void report_losses(std::vector<Finding>& findings, const Report& report, const Evidence& evidence) {
    const std::vector<Index> component = vertex_components(evidence.shell);
    if (!evidence.unused_vertices.empty()) {
        const auto locked =
            std::count_if(evidence.unused_vertices.begin(), evidence.unused_vertices.end(),
                          [&](Index v) { return v < evidence.shell.locked.size() && evidence.shell.locked[v]; });
        Finding finding = warning("CULL_UNUSED_SHELL_VERTICES", 0,
                                  "shell vertices that no tet uses (" + std::to_string(locked) +
                                      " of them locked): they stay as nodes, but nothing hangs on them");
        for (const Index v : evidence.unused_vertices) {
            count_one(finding, {evidence.shell.positions[v], v, evidence.shell.components[component[v]].name});
        }
        findings.push_back(std::move(finding));
    }
    Finding lost = warning("CULL_COMPONENT_WITHOUT_TETS", 0,
                           "shell components of which no tet is left: too thin, open, or "
                           "inside another component of less volume");
    for (Index c = 0; c < report.regions.size(); ++c) {
        if (report.regions[c].tets > 0 || report.regions[c].role == Role::cavity) continue;
        ++lost.count;
        const auto vertex = std::find(component.begin(), component.end(), c);
        if (!wants_place(lost) || vertex == component.end()) continue;
        const auto v = static_cast<Index>(vertex - component.begin());
        lost.places.push_back({evidence.shell.positions[v], v, report.regions[c].name});
    }
    if (lost.count > 0) findings.push_back(std::move(lost));
}

void report_doubt(std::vector<Finding>& findings, const Report& report, const Evidence& evidence) {
    Finding open = warning("CULL_OPEN_SHELL", 0,
                           "open components: the winding number decided what is inside; " +
                               percent_text(report.leak_share) + " of the volume is undecided; close the holes");
    for (Index c = 0; c < evidence.solid.is_closed.size(); ++c) {
        if (!evidence.solid.is_closed[c]) count_one(open, {{}, c, evidence.shell.components[c].name});
    }
    if (open.count > 0) findings.push_back(std::move(open));
    if (report.leak_share > noticeable_leak) {
        findings.push_back(warning("CULL_LEAK", 1,
                                   "inside and outside are not told apart in " + percent_text(report.leak_share) +
                                       " of the volume: close the shell's holes or give a sheet a thickness"));
    }
    if (!report.shell_volume_is_exact) {
        findings.push_back(
            {"CULL_VOLUME_ESTIMATED",
             Severity::info,
             "shells are open, cross or touch: the solid's volume is estimated from samples, stratified by tets",
             1,
             {}});
    }
}

}

std::vector<Index> vertex_components(const Shell& shell) {
    std::vector<Index> component(shell.positions.size(), none);
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        for (const Index v : shell.triangles[f]) component[v] = shell.component[f];
    }
    return component;
}

std::vector<Index> unused_shell_vertices(const Shell& shell, const TetMesh& mesh) {
    std::vector<std::uint8_t> wanted(shell.positions.size(), 0);
    for (const Triangle& triangle : shell.triangles) {
        for (const Index v : triangle) wanted[v] = 1;
    }
    for (const Tet& tet : mesh.tets) {
        for (const Index v : tet) {
            if (v < wanted.size()) wanted[v] = 0;
        }
    }
    std::vector<Index> unused;
    for (Index v = 0; v < wanted.size(); ++v) {
        if (wanted[v]) unused.push_back(v);
    }
    return unused;
}

std::vector<Finding> describe_findings(const Report& report, const Evidence& evidence) {
    std::vector<Finding> findings;
    report_shape(findings, report, evidence);
    report_topology(findings, report, evidence);
    report_losses(findings, report, evidence);
    report_doubt(findings, report, evidence);
    return findings;
}

}
