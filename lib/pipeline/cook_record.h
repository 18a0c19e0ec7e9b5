// SPDX-License-Identifier: GPL-3.0-or-later
// What a file tells about how it came to be: inputs by digest, stages with version, parameters and report. The same for
// the same inputs and recipe: no path, time, host or user.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/workspace.h"

namespace crumple::pipeline {

struct InputRecord {
    std::string name;    // "shell", "visual/<name>", "<either>/buffer/<n>", "points"
    std::string sha256;  // of the file's bytes
};

template <class Visitor, FieldsOf<InputRecord> R>
void describe(Visitor& visit, R& r) {
    visit.field("name", r.name, "shell, visual/<name> or points; <that>/buffer/<n>: a file that belongs to it");
    visit.field("sha256", r.sha256, "of the file's bytes");
}

struct CookRecord {
    std::string tool_version;
    std::vector<InputRecord> inputs;
    std::vector<StageRecord> stages;  // in the order they ran
};

template <class Visitor, FieldsOf<CookRecord> R>
void describe(Visitor& visit, R& r) {
    visit.field("tool_version", r.tool_version, "of the program that wrote the file");
    visit.field("inputs", r.inputs, "what was read");
    visit.field("stages", r.stages, "what ran, in order");
}

[[nodiscard]] CookRecord cook_record(const Workspace& workspace);
[[nodiscard]] std::string cook_record_json(const Workspace& workspace);

// Throws Error(bad_input). Stages this program does not know are kept.
void read_cook_record(std::string_view json, std::string_view source, Workspace& workspace);

// For the bundle: tool and stage versions, the parameters of every stage as one line of JSON, inputs by digest.
[[nodiscard]] BundleProvenance provenance_of(const Workspace& workspace);

}
