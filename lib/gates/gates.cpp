// SPDX-License-Identifier: GPL-3.0-or-later
#include "gates/gates.h"

#include <algorithm>

#include "bundle/summary.h"
#include "gates/bundle_mesh.h"
#include "gates/fidelity.h"
#include "gates/judge.h"

namespace crumple::gates {

namespace {

std::vector<std::string> material_names(const Bundle& bundle) {
    std::vector<std::string> names;
    for (const Material& material : bundle.materials) names.push_back(material.name);
    return names;
}

std::vector<Vec3> painted_places(const Bundle& bundle) {
    std::vector<Vec3> places;
    for (const Vec3f p : bundle.locked_positions) places.push_back({p.x, p.y, p.z});
    return places;
}

// What the bundle itself says of its visual meshes, in its own floats: the same whether the asset is at hand or not.
void count_embedding(const Bundle& bundle, quality::Embedding& embedding) {
    embedding.vertices = embedding.outside = 0;
    embedding.max_weight = 0;
    for (const VisualSummary& visual : summarize(bundle).visuals) {
        embedding.vertices += visual.vertices;
        embedding.outside += visual.outside;
        embedding.max_weight = std::max(embedding.max_weight, visual.max_abs_weight);
    }
}

std::vector<Finding> findings_of(const Bundle& bundle, const quality::Figures& figures, const TetMesh& mesh,
                                 const Shell* shell, const Params& params, const quality::EmbeddingResult* embedding) {
    const std::vector<std::string> materials = material_names(bundle);
    const std::vector<Vec3> painted = painted_places(bundle);
    const quality::PlaceNames names{bundle.regions, materials, bundle.material, painted};
    std::vector<Finding> findings = judge(figures, mesh, shell, params.limits, names, embedding);
    for (Finding& finding : findings) {
        if (!params.enforce && finding.severity == Severity::error) finding.severity = Severity::warning;
    }
    return findings;
}

// What was told with the shell at hand knows places and reasons that the tets alone do not.
void prefer_told(const std::vector<Finding>& told, std::vector<Finding>& findings) {
    for (Finding& finding : findings) {
        const auto same = std::find_if(told.begin(), told.end(), [&](const Finding& f) {
            return f.code == finding.code && f.severity == finding.severity;
        });
        if (same != told.end()) finding = *same;
    }
}

}

Report judge_bundle(const Bundle& bundle, const Asset& asset, const Solid& solid, const Params& params,
                    const Context& context) {
    context.tell_progress("gates", 0);
    TetMesh mesh = mesh_of(bundle);
    const Shell shell = shell_over(bundle, asset.shell, mesh);
    Report report;
    quality::Figures& figures = report.figures;
    figures = quality::measure(mesh, &shell, context);
    context.stop_if_cancelled();
    context.tell_progress("gates", 0.6);
    const Measured measured = measure_fidelity(asset.shell, mesh, solid, params.hausdorff_samples, context);
    figures.fidelity = measured.fidelity;
    figures.topology.shell_pieces = measured.shell_pieces;
    context.stop_if_cancelled();
    context.tell_progress("gates", 0.8);
    const auto embedding = quality::measure_embedding(asset.shell, mesh, asset.visuals, bindings_of(bundle), context);
    figures.embedding = embedding.total;
    count_embedding(bundle, figures.embedding);
    report.findings = findings_of(bundle, figures, mesh, &shell, params, &embedding);
    context.tell_progress("gates", 1);
    return report;
}

Report judge_again(const Bundle& bundle, const Report& told, const Params& params, const Context& context) {
    const TetMesh mesh = mesh_of(bundle);
    Report report;
    quality::Figures& figures = report.figures;
    figures = quality::measure(mesh, nullptr, context);
    figures.below_10_thin = std::min<std::uint64_t>(told.figures.below_10_thin, figures.shape.below_10_deg);
    figures.below_10_needle =
        std::min<std::uint64_t>(told.figures.below_10_needle, figures.shape.below_10_deg - figures.below_10_thin);
    figures.topology.shell_pieces = told.figures.topology.shell_pieces;
    figures.fidelity = told.figures.fidelity;
    figures.embedding = told.figures.embedding;
    count_embedding(bundle, figures.embedding);
    report.findings = findings_of(bundle, figures, mesh, nullptr, params, nullptr);
    prefer_told(told.findings, report.findings);
    return report;
}

}
