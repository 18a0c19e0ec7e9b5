// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/version.h"

#include "pipeline/stage_table.h"

namespace crumple::pipeline {

std::string_view tool_version() { return CRUMPLE_VERSION; }

VersionInfo version_info() {
    VersionInfo info;
    info.version = tool_version();
    for (const Stage& stage : stage_table()) info.stages.push_back({std::string(stage.name), stage.version});
    return info;
}

}
