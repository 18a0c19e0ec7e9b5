// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/schemas.h"

#include "pipeline/baseline.h"
#include "pipeline/check.h"
#include "pipeline/compare.h"
#include "pipeline/cook.h"
#include "pipeline/inspect.h"
#include "pipeline/progress.h"
#include "pipeline/version.h"
#include "report/json_schema.h"

namespace crumple::pipeline {

namespace {

using report::SchemaTitle;
using report::SchemaUse;

template <class Output>
SchemaFile output_schema(const SchemaTitle& title) {
    const Output example;
    return {std::string(title.id) + ".schema.json",
            report::write_schema(report::Described::of(example), title, SchemaUse::output)};
}

template <class Input>
SchemaFile input_schema(const SchemaTitle& title) {
    const Input example;
    return {std::string(title.id) + ".schema.json",
            report::write_schema(report::Described::of(example), title, SchemaUse::input)};
}

SchemaFile stage_schema(const Stage& stage) {
    const std::string id = "stage_" + std::string(stage.name);
    const report::OwnedDescribed example = stage.make_report();
    const SchemaTitle title{id, id, stage.help};
    return {id + ".schema.json", report::write_schema(example.view(), title, SchemaUse::output)};
}

}

std::vector<SchemaFile> all_schemas() {
    std::vector<SchemaFile> files{
        {"recipe.schema.json", recipe_schema()},
        output_schema<CookReport>({"cook_report", "cook report", "crumple cook --report FILE, --format json"}),
        output_schema<DryRunReport>({"dry_run", "dry run", "crumple cook --dry-run --format json"}),
        output_schema<CheckReport>({"check", "check", "crumple check --format json"}),
        output_schema<InspectReport>({"inspect", "inspect", "crumple inspect --format json"}),
        output_schema<CompareReport>({"compare", "compare", "crumple compare --format json"}),
        output_schema<ProgressLine>({"progress", "line of progress", "each line of --progress json"}),
        output_schema<VersionInfo>({"version", "version", "crumple --version --json"}),
        input_schema<BaselineFile>({"baseline", "baseline", "crumple check --baseline FILE"}),
        output_schema<Finding>({"finding", "finding", "what every list of findings holds"}),
    };
    for (const Stage& stage : stage_table()) files.push_back(stage_schema(stage));
    return files;
}

}
