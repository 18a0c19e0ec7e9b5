// SPDX-License-Identifier: GPL-3.0-or-later
// A shell as a file would have it, taken from import to the culled mesh.
#pragma once
#include <functional>
#include <string>

#include "core/error.h"
#include "cull/cull.h"
#include "delaunay/delaunay.h"
#include "geometry/predicates.h"
#include "importer/import.h"
#include "importer/obj_text.h"
#include "importer/temp_folder.h"
#include "mesh/neighbours.h"
#include "mesh/validate.h"
#include "relax/relax.h"
#include "sample/sample.h"

namespace crumple::test {

struct Cooked {
    std::string refusal;  // empty: it went through
    Asset asset;
    importer::Report import;
    sample::Report sample;
    TetMesh mesh;
    cull::Report cull;

    [[nodiscard]] const Finding* find(const std::string& code) const {
        for (const auto* findings : {&import.findings, &sample.findings, &cull.findings}) {
            for (const Finding& finding : *findings) {
                if (finding.code == code) return &finding;
            }
        }
        return nullptr;
    }
    [[nodiscard]] bool has(const std::string& code) const { return find(code) != nullptr; }
};

// A refusal must be about the input; anything else is a bug and passes through. Few sweeps: these tests are not about
// quality.
inline Cooked cook_text(const std::string& obj, const importer::Params& params = {}) {
    const TempFolder folder;
    Cooked cooked;
    try {
        importer::Result imported = importer::import_asset({folder.write("shell.obj", obj), {}}, params);
        cooked.asset = std::move(imported.asset);
        cooked.import = std::move(imported.report);
        const Shell& shell = cooked.asset.shell;
        sample::Result sampled = sample::sample_interior(shell);
        cooked.sample = std::move(sampled.report);
        relax::Params few;
        few.sweeps = 2;
        TetMesh mesh = delaunay::tetrahedralize(sampled.points).mesh;
        mesh = relax::relax_points(std::move(mesh), shell, few).mesh;
        cull::Result culled = cull::cull_outside(shell, std::move(mesh));
        cooked.mesh = std::move(culled.mesh);
        cooked.cull = std::move(culled.report);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_input) throw;
        cooked.refusal = error.what();
    }
    return cooked;
}

inline Cooked cook_shell(const Shell& shell, const importer::Params& params = {},
                         const std::function<double(std::size_t)>& red = {}) {
    return cook_text(obj_text(shell, red), params);
}

// Empty for a mesh that later stages can rely on, else what is wrong with it.
inline std::string fault_of(const Cooked& cooked) {
    for (const Finding& finding : validate(cooked.asset.shell)) return finding.code;
    for (const Finding& finding : validate(cooked.mesh, static_cast<Index>(cooked.asset.shell.components.size())))
        return finding.code;
    if (cooked.mesh.tets.empty()) return "no tets";
    // A component may vanish, but never in silence.
    for (const cull::Region& region : cooked.cull.regions) {
        const bool is_lost = region.tets == 0 && region.role != Role::cavity;
        if (is_lost && !cooked.has("CULL_COMPONENT_WITHOUT_TETS")) return "lost " + region.name;
    }
    return {};
}

}
