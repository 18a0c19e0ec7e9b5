// SPDX-License-Identifier: GPL-3.0-or-later
// A shell as a file would have it, taken from import to the culled mesh and on to the finished one.
#pragma once
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "core/error.h"
#include "cull/cull.h"
#include "delaunay/delaunay.h"
#include "finish/finish.h"
#include "geometry/predicates.h"
#include "importer/import.h"
#include "importer/obj_text.h"
#include "importer/temp_folder.h"
#include "mesh/neighbours.h"
#include "mesh/validate.h"
#include "recover/recover.h"
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
        mesh = recover::recover_shell(std::move(mesh), shell).mesh;
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

// Empty for tets that later stages can rely on, else what is wrong with them.
inline std::string fault_of(const TetMesh& mesh, const Shell& shell) {
    for (const Finding& finding : validate(mesh, static_cast<Index>(shell.components.size()))) return finding.code;
    if (mesh.tets.empty()) return "no tets";
    if (!std::equal(shell.positions.begin(), shell.positions.end(), mesh.positions.begin())) return "vertices moved";
    return {};
}

inline std::string fault_of(const Cooked& cooked) {
    for (const Finding& finding : validate(cooked.asset.shell)) return finding.code;
    if (std::string fault = fault_of(cooked.mesh, cooked.asset.shell); !fault.empty()) return fault;
    // A component may vanish, but never in silence.
    for (const cull::Region& region : cooked.cull.regions) {
        const bool is_lost = region.tets == 0 && region.role != Role::cavity;
        if (is_lost && !cooked.has("CULL_COMPONENT_WITHOUT_TETS")) return "lost " + region.name;
    }
    return {};
}

// The same once the culled mesh is finished: what had a tet of the shell's vertices keeps one.
inline std::string fault_when_finished(const Cooked& cooked) {
    const Shell& shell = cooked.asset.shell;
    const TetMesh mesh = finish::finish_mesh(shell, cooked.mesh).mesh;
    std::vector<bool> is_lost(shell.positions.size());
    const auto mark = [&](const TetMesh& tets, bool value) {
        for (const Tet& tet : tets.tets) {
            for (const Index node : tet) {
                if (node < is_lost.size()) is_lost[node] = value;
            }
        }
    };
    mark(cooked.mesh, true);
    mark(mesh, false);
    const auto lost = std::find(is_lost.begin(), is_lost.end(), true);
    if (lost != is_lost.end()) return "lost vertex " + std::to_string(lost - is_lost.begin());
    return fault_of(mesh, shell);
}

}
