// SPDX-License-Identifier: GPL-3.0-or-later
// The stages in the order they run. A row here is all that makes a stage a verb, a recipe key and a schema.
#pragma once
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/context.h"
#include "pipeline/workspace.h"
#include "report/described.h"

namespace crumple::pipeline {

struct Stage {
    std::string_view name;  // verb, recipe key, schema
    int version;            // changes when its output does
    std::string_view help;
    std::vector<Group> reads;  // must be there
    Group writes;              // groups after it are forgotten
    report::OwnedDescribed (*make_params)();
    report::OwnedDescribed (*make_report)();
    // Refuses, with Error(usage), parameters that do not fit each other or say nothing.
    void (*check_params)(const report::OwnedDescribed& params);
    // Params in, report out, data in the workspace.
    report::OwnedDescribed (*run)(Workspace& workspace, const report::OwnedDescribed& params, const Context& context);
};

// import sample delaunay relax recover cull finish bind bake gates
[[nodiscard]] std::span<const Stage> stage_table();

// Throws Error(usage) that names the nearest stage.
[[nodiscard]] const Stage& find_stage(std::string_view name);

[[nodiscard]] std::size_t stage_index(std::string_view name);

}
