// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/stage_table.h"

#include <algorithm>
#include <string>

#include "bake/bake.h"
#include "bind/bind.h"
#include "core/names.h"
#include "cull/cull.h"
#include "delaunay/delaunay.h"
#include "finish/finish.h"
#include "gates/gates.h"
#include "importer/import.h"
#include "pipeline/bundle_gates.h"
#include "pipeline/contradictions.h"
#include "pipeline/input_digests.h"
#include "recover/recover.h"
#include "relax/relax.h"
#include "sample/sample.h"

namespace crumple::pipeline {

namespace {

importer::Report run_import(Workspace& work, const importer::Params& params, const Context& context) {
    work.input_digests = digest_inputs(importer::input_files(work.sources, params));
    auto result = importer::import_asset(work.sources, params, context);
    work.asset = std::move(result.asset);
    return std::move(result.report);
}

sample::Report run_sample(Workspace& work, const sample::Params& params, const Context& context) {
    auto result = sample::sample_interior(work.asset->shell, params, context);
    work.points = std::move(result.points);
    return std::move(result.report);
}

delaunay::Report run_delaunay(Workspace& work, const delaunay::Params& params, const Context& context) {
    if (work.asset && !begins_with_shell(work.points->positions, work.points->shell_vertex_count, work.asset->shell)) {
        throw Error(ErrorKind::bad_input,
                    "the points are not those of the shell, whose vertices have moved since; run crumple sample again");
    }
    auto result = delaunay::tetrahedralize(*work.points, params, context);
    if (result.mesh.tets.empty()) {
        const auto& findings = result.report.findings;
        throw Error(ErrorKind::bad_input, "delaunay: " + (findings.empty() ? "no tets" : findings.front().message));
    }
    work.tets = std::move(result.mesh);
    return std::move(result.report);
}

relax::Report run_relax(Workspace& work, const relax::Params& params, const Context& context) {
    auto result = relax::relax_points(std::move(*work.tets), work.asset->shell, params, context);
    work.tets = std::move(result.mesh);
    return std::move(result.report);
}

recover::Report run_recover(Workspace& work, const recover::Params& params, const Context& context) {
    auto result = recover::recover_shell(std::move(*work.tets), work.asset->shell, params, context);
    work.tets = std::move(result.mesh);
    return std::move(result.report);
}

cull::Report run_cull(Workspace& work, const cull::Params& params, const Context& context) {
    auto result = cull::cull_outside(work.asset->shell, std::move(*work.tets), params, context);
    work.tets = std::move(result.mesh);
    return std::move(result.report);
}

// The group of tets is there from delaunay on, what they are made of only after cull.
void require_regions(const TetMesh& tets) {
    if (tets.region.size() != tets.tets.size())
        throw Error(ErrorKind::bad_input, "the tets do not say yet what they are made of; run crumple cull first");
}

finish::Report run_finish(Workspace& work, const finish::Params& params, const Context& context) {
    require_regions(*work.tets);
    auto result = finish::finish_mesh(work.asset->shell, std::move(*work.tets), params, context);
    work.tets = std::move(result.mesh);
    // Where the artist lets vertices slide, they lie elsewhere from here on.
    std::vector<Vec3>& shell = work.asset->shell.positions;
    if (params.slide > 0) std::copy_n(work.tets->positions.begin(), shell.size(), shell.begin());
    return std::move(result.report);
}

bind::Report run_bind(Workspace& work, const bind::Params& params, const Context& context) {
    require_regions(*work.tets);
    auto result = bind::bind_visuals(work.asset->shell, *work.tets, work.asset->visuals, params, context);
    work.bindings = std::move(result.bindings);
    return std::move(result.report);
}

bake::Report run_bake(Workspace& work, const bake::Params& params, const Context& context) {
    require_regions(*work.tets);
    auto result = bake::bake_bundle(*work.asset, *work.tets, *work.bindings, params, context);
    work.bundle = std::move(result.bundle);
    return std::move(result.report);
}

gates::Report run_gates(Workspace& work, const gates::Params& params, const Context& context) {
    return judge_cooked(work, params, context);
}

// A row out of Report run(Workspace&, const Params&, const Context&).
template <auto run>
struct Row;

template <class Report, class Params, Report (*run)(Workspace&, const Params&, const Context&)>
struct Row<run> {
    static report::OwnedDescribed make_params() { return report::OwnedDescribed::make<Params>(); }
    static report::OwnedDescribed make_report() { return report::OwnedDescribed::make<Report>(); }
    static void check(const report::OwnedDescribed& params) {
        if constexpr (requires(const Params& p) { check_params(p); }) check_params(params.as<Params>());
    }
    static report::OwnedDescribed run_erased(Workspace& work, const report::OwnedDescribed& params,
                                             const Context& context) {
        return report::OwnedDescribed::make<Report>(run(work, params.as<Params>(), context));
    }
};

template <auto run>
Stage row(std::string_view name, int version, std::vector<Group> reads, Group writes, std::string_view help) {
    using R = Row<run>;
    return {name, version, help, std::move(reads), writes, R::make_params, R::make_report, R::check, R::run_erased};
}

}

std::span<const Stage> stage_table() {
    using enum Group;
    static const std::vector<Stage> table{
        row<run_import>("import", importer::version, {}, asset, "read the painted shell and the visual meshes"),
        row<run_sample>("sample", sample::version, {asset}, points, "put points inside the shell"),
        row<run_delaunay>("delaunay", delaunay::version, {points}, tets, "connect the points to tetrahedra, exactly"),
        row<run_relax>("relax", relax::version, {asset, tets}, tets, "move interior nodes until the shapes are good"),
        row<run_recover>("recover", recover::version, {asset, tets}, tets,
                         "bring the shell's edges and triangles back into the tets"),
        row<run_cull>("cull", cull::version, {asset, tets}, tets, "throw away what lies outside the shell"),
        row<run_finish>("finish", finish::version, {asset, tets}, tets, "mend bad shapes, shell vertices staying put"),
        row<run_bind>("bind", bind::version, {asset, tets}, bindings, "hang the visual meshes on the tetrahedra"),
        row<run_bake>("bake", bake::version, {asset, tets, bindings}, bundle, "turn it into the arrays a game loads"),
        row<run_gates>("gates", gates::version, {asset, bundle}, bundle, "hold the result against what it must be"),
    };
    return table;
}

std::size_t stage_index(std::string_view name) {
    const std::span<const Stage> table = stage_table();
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (table[i].name == name) return i;
    }
    std::vector<std::string> names;
    for (const Stage& stage : table) names.emplace_back(stage.name);
    throw Error(ErrorKind::usage, "no stage '" + std::string(name) + "'; nearest: '" + nearest_name(name, names) +
                                      "' (there are: " + list_names(names) + ")");
}

const Stage& find_stage(std::string_view name) { return stage_table()[stage_index(name)]; }

}
