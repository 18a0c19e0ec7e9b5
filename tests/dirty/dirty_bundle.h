// SPDX-License-Identifier: GPL-3.0-or-later
// The finished mesh of a dirty shell taken on to what a game loads: hung with a visual mesh, baked and judged.
#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "bake/bake.h"
#include "bind/bind.h"
#include "bundle/validate.h"
#include "dirty/dirty_shell.h"
#include "gates/gates.h"

namespace crumple::test {

struct Bundled {
    std::string refusal;  // empty: it went through
    Bundle bundle;
    gates::Report gates;
};

// Stands for the car's paint: the shell's vertices, and the middles of its triangles.
inline VisualMesh visual_of(const Shell& shell) {
    VisualMesh visual;
    visual.name = "paint";
    visual.positions = shell.positions;
    for (const auto& [a, b, c] : shell.triangles) {
        visual.positions.push_back(
            round_to_float((shell.positions[a] + shell.positions[b] + shell.positions[c]) / 3.0));
    }
    for (Index v = 0; v < visual.positions.size(); ++v) visual.source_vertex.push_back(v);
    return visual;
}

// As of cook_text: what is no fault of the input passes through.
inline Bundled bundle_of(Cooked cooked) {
    Bundled result;
    Asset& asset = cooked.asset;
    asset.visuals = {visual_of(asset.shell)};
    try {
        const Bindings bindings = bind::bind_visuals(asset.shell, cooked.finished, asset.visuals).bindings;
        result.bundle = bake::bake_bundle(asset, cooked.finished, bindings).bundle;
        const cull::Report& cull = cooked.cull;
        result.gates =
            gates::judge_bundle(result.bundle, asset, {cull.shell_volume, cull.leak_share, cull.shell_pieces});
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_input) throw;
        result.refusal = error.what();
    }
    return result;
}

// Empty for a bundle that is all it says it is: its invariants hold, no tet is inverted, the gates say the same again
// without the asset.
inline std::string fault_of(const Bundled& of) {
    for (const Finding& finding : validate(of.bundle)) return finding.code;
    const quality::Figures& figures = of.gates.figures;
    if (figures.shape.inverted > 0) return "inverted tets";
    if (!(figures.cost.pcg_soft > 0 && figures.cost.pcg_stiff > 0)) return "no iterations";
    if (!std::isfinite(figures.fidelity.volume_error)) return "volume error";
    const gates::Report again = gates::judge_again(of.bundle, of.gates);
    if (again.findings.size() != of.gates.findings.size()) return "another verdict without the asset";
    for (std::size_t i = 0; i < again.findings.size(); ++i) {
        const Finding& told = of.gates.findings[i];
        if (again.findings[i].code != told.code || again.findings[i].severity != told.severity)
            return "another verdict without the asset: " + told.code;
        if (told.message.find("; ") == std::string::npos) return told.code + " without advice";
    }
    return {};
}

}
