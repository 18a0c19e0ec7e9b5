// SPDX-License-Identifier: GPL-3.0-or-later
#include "bake/bake.h"

#include "bake/bake_bindings.h"
#include "bake/bake_nodes.h"
#include "bake/bake_sensors.h"
#include "bake/bake_tets.h"
#include "bake/check_input.h"
#include "bake/choose_materials.h"
#include "bake/light_nodes.h"
#include "bundle/matrix_pattern.h"
#include "bundle/validate.h"
#include "core/error.h"

namespace crumple::bake {
namespace {

// What bake hands out passes check, or it does not leave.
void require_valid(const Bundle& bundle) {
    const std::vector<Finding> wrong = validate(bundle);
    if (wrong.empty()) return;
    const ErrorKind kind = wrong.front().code == "BUNDLE_FACE" ? ErrorKind::bad_input : ErrorKind::internal;
    throw Error(kind, "bake: " + wrong.front().code + ": " + wrong.front().message);
}

}

Result bake_bundle(const Asset& asset, const TetMesh& mesh, const Bindings& bindings, const Params& params,
                   const Context& context) {
    check_params(params);
    check_input(asset, mesh, bindings);
    Result result;
    auto& [bundle, report] = result;
    const auto component_materials = choose_materials(asset.shell, params, report.findings);
    context.tell_progress("bake", 0);
    bake_nodes(asset.shell, mesh, params.node_order, bundle, report);
    bake_locks(asset, mesh, bundle, report);
    const TetOrder order = bake_tets(mesh, bundle);
    bake_rest_state(asset.shell, mesh, order, params, component_materials, bundle, report);
    context.stop_if_cancelled();
    build_matrix_pattern(bundle);
    context.tell_progress("bake", 0.5);
    bundle.visuals = bake_bindings(bindings, order);
    bundle.sensors = bake_sensors(asset.shell, bundle, params, report.findings);
    context.stop_if_cancelled();
    require_valid(bundle);
    warn_of_light_nodes(bundle, params.step_s, report.findings);
    report.bundle = summarize(bundle);
    context.tell_progress("bake", 1);
    return result;
}

}
