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
#include "mesh/boundary.h"
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
    TetMesh mesh;  // culled
    cull::Report cull;
    TetMesh finished;
    finish::Report finish;

    [[nodiscard]] const Finding* find(const std::string& code) const {
        for (const auto* findings : {&import.findings, &sample.findings, &cull.findings, &finish.findings}) {
            for (const Finding& finding : *findings) {
                if (finding.code == code) return &finding;
            }
        }
        return nullptr;
    }
    [[nodiscard]] bool has(const std::string& code) const { return find(code) != nullptr; }
    [[nodiscard]] bool informs(const std::string& code) const { return has(code, Severity::info); }
    [[nodiscard]] bool warns(const std::string& code) const { return has(code, Severity::warning); }

private:
    [[nodiscard]] bool has(const std::string& code, Severity severity) const {
        const Finding* finding = find(code);
        return finding && finding->severity == severity;
    }
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
        finish::Result finished = finish::finish_mesh(shell, cooked.mesh);
        cooked.finished = std::move(finished.mesh);
        cooked.finish = std::move(finished.report);
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

// The first shell vertex that had a tet and has none any more, as text; empty: there is no such vertex.
inline std::string lost_vertex(const TetMesh& before, const TetMesh& after) {
    std::vector<bool> is_lost(before.shell_vertex_count);
    const auto mark = [&](const TetMesh& mesh, bool value) {
        for (const Tet& tet : mesh.tets) {
            for (const Index node : tet) {
                if (node < is_lost.size()) is_lost[node] = value;
            }
        }
    };
    mark(before, true);
    mark(after, false);
    const auto lost = std::find(is_lost.begin(), is_lost.end(), true);
    return lost == is_lost.end() ? "" : "lost vertex " + std::to_string(lost - is_lost.begin());
}

// Empty: valid from cull to the end, no vertex lost on the way.
inline std::string fault_but_for_touching(const Cooked& cooked) {
    for (const Finding& finding : validate(cooked.asset.shell)) return finding.code;
    if (std::string fault = fault_of(cooked.mesh, cooked.asset.shell); !fault.empty()) return fault;
    // A component may vanish, but never in silence.
    for (const cull::Region& region : cooked.cull.regions) {
        const bool is_lost = region.tets == 0 && region.role != Role::cavity;
        if (is_lost && !cooked.has("CULL_COMPONENT_WITHOUT_TETS")) return "lost " + region.name;
    }
    if (std::string fault = fault_of(cooked.finished, cooked.asset.shell); !fault.empty()) return "finished: " + fault;
    return lost_vertex(cooked.mesh, cooked.finished);
}

// Places where the finished surface is no manifold.
inline NonManifold touching(const Cooked& cooked) { return non_manifold(boundary_of(cooked.finished).faces); }

// Empty: what a game should be given, with a manifold surface whatever the shell was.
inline std::string fault_of(const Cooked& cooked) {
    if (std::string fault = fault_but_for_touching(cooked); !fault.empty()) return fault;
    const NonManifold left = touching(cooked);
    if (left.edges.empty() && left.vertices.empty()) return {};
    return std::to_string(left.edges.size()) + " edges and " + std::to_string(left.vertices.size()) +
           " nodes where the surface touches itself";
}

}
