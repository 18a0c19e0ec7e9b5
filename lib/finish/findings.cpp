// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/findings.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "mesh/boundary.h"
#include "quality/place_teller.h"
#include "quality/shell_limits.h"
#include "quality/tet_measures.h"

namespace crumple::finish {

namespace {

using quality::ShellLimit;

// What an artist knows a region by.
std::vector<std::string> names_of(const Shell& shell) {
    std::vector<std::string> names;
    for (const Component& component : shell.components) {
        names.push_back("'" + component.name + "'");
        if (!component.material.empty()) names.back() += " of material '" + component.material + "'";
    }
    return names;
}

// The tets below 10 degrees, flattest first, ties by number.
struct BadTet {
    double angle_deg;
    Index tet;
};

std::vector<BadTet> find_bad(const TetMesh& mesh) {
    std::vector<BadTet> bad;
    for (Index t = 0; t < mesh.tets.size(); ++t) {
        const auto& [a, b, c, d] = mesh.tets[t];
        const auto& p = mesh.positions;
        const quality::AngleKey key = quality::min_dihedral_key(p[a], p[b], p[c], p[d]);
        if (key < quality::key_of_10_deg) bad.push_back({quality::degrees_of(key), t});
    }
    std::sort(bad.begin(), bad.end(), [](const BadTet& a, const BadTet& b) {
        return a.angle_deg != b.angle_deg ? a.angle_deg < b.angle_deg : a.tet < b.tet;
    });
    return bad;
}

Finding empty_finding(ShellLimit limit) {
    switch (limit) {
        case ShellLimit::thin:
            return {"FINISH_FORCED_THIN",
                    Severity::info,
                    "tets below 10 degrees where the shell is thin for its long edges: no mesh that keeps its vertices "
                    "does better; give it more vertices there, or more thickness",
                    0,
                    {}};
        case ShellLimit::needle:
            return {
                "FINISH_FORCED_NEEDLE",
                Severity::info,
                "tets below 10 degrees on needle triangles of the shell: no mesh that keeps them does better; merge "
                "the near vertices or turn the edges there",
                0,
                {}};
        case ShellLimit::gap:
            return {
                "FINISH_FORCED_GAP",
                Severity::info,
                "tets below 10 degrees where two surfaces of the shell nearly meet: no mesh between them does better; "
                "delete one that is a copy, or move them apart",
                0,
                {}};
        case ShellLimit::none:
            break;
    }
    return {"FINISH_BAD_TETS",
            Severity::warning,
            "tets below 10 degrees that are not the shell's fault: more interior points or another seed may help, or "
            "looser bounds for the surface (fold_deg, surface_gap)",
            0,
            {}};
}

void report_bad_tets(const Shell& shell, const TetMesh& mesh, Report& report, const Context& context) {
    const std::vector<BadTet> bad = find_bad(mesh);
    std::vector<Tet> tets;
    for (const BadTet& entry : bad) tets.push_back(mesh.tets[entry.tet]);
    const std::vector<ShellLimit> limits =
        quality::find_limits({shell.positions, shell.triangles}, mesh.positions, tets, context);
    const std::vector<std::string> names = names_of(shell);
    quality::PlaceNames place_names;
    place_names.components = names;
    const quality::PlaceTeller teller(mesh, {shell.positions, shell.triangles}, place_names);
    for (const ShellLimit limit : {ShellLimit::none, ShellLimit::thin, ShellLimit::needle, ShellLimit::gap}) {
        Finding finding = empty_finding(limit);
        for (std::size_t i = 0; i < bad.size(); ++i) {
            if (limits[i] != limit) continue;
            ++finding.count;
            if (!wants_place(finding)) continue;
            char text[32];
            std::snprintf(text, sizeof text, "%.3g degrees", bad[i].angle_deg);
            finding.places.push_back(teller.at_tet(bad[i].tet, text));
        }
        if (limit == ShellLimit::none) report.failed = finding.count;
        if (limit == ShellLimit::thin) report.forced_thin = finding.count;
        if (limit == ShellLimit::needle) report.forced_needle = finding.count;
        if (limit == ShellLimit::gap) report.forced_gap = finding.count;
        if (finding.count > 0) report.findings.push_back(std::move(finding));
    }
}

void report_repair(const TetMesh& mesh, Report& report) {
    const Repair& repair = report.repair;
    if (repair.removed + repair.added + repair.split + repair.bent + repair.cut > 0) {
        report.findings.push_back(
            {"FINISH_REPAIRED",
             Severity::info,
             "nodes where the surface of the tets touched itself: " + std::to_string(repair.removed) +
                 " tets taken away, " + std::to_string(repair.added) + " added, " + std::to_string(repair.split) +
                 " nodes copied, " + std::to_string(repair.bent + repair.cut) + " places parted by new nodes",
             repair.nodes_before,
             {}});
    }
    if (report.repair.nodes_left == 0) return;
    Finding finding{
        "FINISH_NON_MANIFOLD",
        Severity::warning,
        "nodes where the surface of the tets still touches itself: they could not be parted in floats without "
        "new faults, or all tets there are locked; leave a gap or unite what touches",
        0,
        {}};
    for (const Index v : non_manifold(boundary_of(mesh).faces).vertices) count_one(finding, {mesh.positions[v], v, {}});
    report.findings.push_back(std::move(finding));
}

}

void judge_result(const Shell& shell, const TetMesh& mesh, Report& report, const Context& context) {
    report_bad_tets(shell, mesh, report, context);
    report_repair(mesh, report);
    if (report.is_out_of_budget) {
        report.findings.push_back({"FINISH_BUDGET",
                                   Severity::warning,
                                   "stopped for want of budget: raise finish.budget, or lower finish.target_deg",
                                   1,
                                   {}});
    }
}

}
