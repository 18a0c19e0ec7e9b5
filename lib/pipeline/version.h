// SPDX-License-Identifier: GPL-3.0-or-later
// Which program this is, with everything a build system may want to key on.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/fields.h"

namespace crumple::pipeline {

[[nodiscard]] std::string_view tool_version();

struct StageVersion {
    std::string name;
    int version = 0;
};

template <class Visitor, FieldsOf<StageVersion> S>
void describe(Visitor& visit, S& s) {
    visit.field("name", s.name, "stage");
    visit.field("version", s.version, "changes when its output does");
}

struct VersionInfo {
    std::string name = "crumple";
    std::string version;
    std::vector<StageVersion> stages;
};

template <class Visitor, FieldsOf<VersionInfo> V>
void describe(Visitor& visit, V& v) {
    visit.field("name", v.name, "program");
    visit.field("version", v.version, "of the program");
    visit.field("stages", v.stages, "in the order they run");
}

[[nodiscard]] VersionInfo version_info();

}
