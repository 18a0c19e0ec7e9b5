// SPDX-License-Identifier: GPL-3.0-or-later
// What assets were at when someone last found them good: `crumple check --baseline FILE`. A strict JSON file that many
// assets may share, kept beside them under version control.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "gates/baseline.h"
#include "pipeline/check.h"

namespace crumple::pipeline {

struct BaselineFile {
    std::string schema = "crumple/baseline/1";
    std::map<std::string, gates::Baseline> assets;  // by the bundle's file name without folder and ending
};

template <class Visitor, FieldsOf<BaselineFile> B>
void describe(Visitor& visit, B& b) {
    visit.field("schema", b.schema, "name and version of this form");
    visit.field("assets", b.assets, "by the bundle's file name without folder and .hdf");
}

// Throws Error(file), or Error(usage) for what is no baseline or lacks a figure of an asset. One that will be updated
// may be absent and lack figures.
[[nodiscard]] BaselineFile load_baseline(const std::string& path, bool will_be_updated);

// Throws Error(usage) for two paths whose bundles go by one name there.
void check_asset_names(const std::vector<std::string>& paths);

// GATE_PCG_SOFT and the like are added to the findings, by the gates the bundle was cooked with; BASELINE_MISSING when
// the file does not know it. Files that were not checked to the end stay as they are.
void compare_with(const BaselineFile& baseline, FileCheck& check);

// Takes over what every bundle that passed and can be simulated has now, and writes the file. Throws Error(file).
void update_baseline(const std::string& path, BaselineFile baseline, const std::vector<FileCheck>& checks);

}
