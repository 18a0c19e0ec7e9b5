// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/cook_record.h"

#include "pipeline/version.h"
#include "report/json_reader.h"
#include "report/json_writer.h"

namespace crumple::pipeline {

CookRecord cook_record(const Workspace& workspace) {
    CookRecord record{std::string(tool_version()), {}, workspace.records};
    for (const auto& [name, digest] : workspace.input_digests) record.inputs.push_back({name, digest});
    return record;
}

std::string cook_record_json(const Workspace& workspace) {
    const CookRecord record = cook_record(workspace);
    return report::write_json(report::Described::of(record), report::JsonStyle::compact);
}

void read_cook_record(std::string_view json, std::string_view source, Workspace& workspace) {
    CookRecord record;
    report::read_json(json, std::string(source) + ": /cook/record", report::Described::of(record),
                      {.kind = ErrorKind::bad_input, .allows_null = true});
    workspace.records = std::move(record.stages);
    workspace.input_digests.clear();
    for (InputRecord& input : record.inputs) workspace.input_digests.push_back({input.name, input.sha256});
}

BundleProvenance provenance_of(const Workspace& workspace) {
    BundleProvenance provenance;
    provenance.tool_version = tool_version();
    report::Json recipe = report::Json::Object{};
    for (const StageRecord& stage : workspace.records) {
        provenance.stage_versions.push_back({stage.name, std::to_string(stage.version)});
        recipe.add(stage.name, report::parse_json(stage.params.text, stage.name));
    }
    provenance.recipe = report::dump_json(recipe, report::JsonStyle::compact);
    provenance.input_digests = workspace.input_digests;
    return provenance;
}

}
