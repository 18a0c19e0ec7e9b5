// SPDX-License-Identifier: GPL-3.0-or-later
// A workspace with a small asset in it, as import would leave it, and the stages after it.
#pragma once
#include <string_view>

#include "mesh/shapes.h"
#include "pipeline/runner.h"

namespace small_work {

inline crumple::pipeline::Workspace imported() {
    crumple::pipeline::Workspace work;
    crumple::Asset asset;
    asset.shell = crumple::shapes::icosphere(1, 1);
    asset.shell.locked[3] = 1;
    asset.locked_positions = {asset.shell.positions[3]};
    crumple::VisualMesh visual;
    visual.name = "body";
    visual.positions = {{0, 0, 0}, {0.25, 0, 0}, {0, 0.25, 0}};
    visual.triangles = {{0, 1, 2}};
    visual.source_vertex = {0, 1, 2};
    asset.visuals.push_back(visual);
    work.asset = asset;
    work.input_digests = {{"shell", std::string(64, 'a')}, {"visual/body", std::string(64, 'b')}};
    work.records.push_back({"import", 1, {"{}"}, {R"({"findings":[]})"}});
    return work;
}

// Runs the named stage with its defaults.
inline crumple::pipeline::StageRun run(std::string_view stage, crumple::pipeline::Workspace& work) {
    const crumple::pipeline::Stage& row = crumple::pipeline::find_stage(stage);
    return crumple::pipeline::run_stage(row, row.make_params(), work, 1);
}

inline crumple::pipeline::Workspace cooked() {
    crumple::pipeline::Workspace work = imported();
    for (const auto& stage : crumple::pipeline::stage_table()) {
        if (stage.name != "import") (void)run(stage.name, work);
    }
    return work;
}

}
