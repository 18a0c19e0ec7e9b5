// SPDX-License-Identifier: GPL-3.0-or-later
// `crumple cook`: every stage of a recipe, from the artist's files to a bundle on the disk, and a report of it all.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "pipeline/budget.h"
#include "pipeline/cook_record.h"
#include "pipeline/exit_codes.h"
#include "pipeline/recipe.h"
#include "pipeline/runner.h"
#include "pipeline/work_file.h"

namespace crumple::pipeline {

struct CookReport;

struct CookRequest {
    importer::Sources sources;
    std::string output;
    FileContents contents{.has_work = false};
    unsigned jobs = 1;
    bool checks_determinism = false;  // cook twice at different numbers of threads, compare before writing
    Permission may_finish;            // asked before the output is put in place; may be empty
    // Told right before, as the report will be: what it cannot write stops the cook while the old output is there.
    std::function<void(const CookReport&)> before_output;
    // Told whenever the report has come further, for those who outlive a cook that is ended; may be empty.
    std::function<void(const CookReport&)> keep_report;
};

struct OutputReport {
    std::uint64_t bytes = 0;
    std::string sha256;
    bool is_unchanged = false;
    bool is_rejected = false;
};

template <class Visitor, FieldsOf<OutputReport> R>
void describe(Visitor& visit, R& r) {
    visit.field("bytes", r.bytes, "size of the file");
    visit.field("sha256", r.sha256, "of the file's bytes");
    visit.field("is_unchanged", r.is_unchanged, "the file held the same bytes before and was not touched");
    visit.field("is_rejected", r.is_rejected, "a quality gate failed: it was written as <output>.rejected.hdf instead");
}

struct CookReport {
    std::string schema = "crumple/cook_report/1";
    std::string tool_version;
    int exit_code = exit_ok;
    std::string error;       // what stopped it
    std::string stopped_in;  // stage, "check_determinism" or "write"; empty when cooked
    std::string recipe;      // name or path as given
    report::RawJson params;
    std::vector<InputRecord> inputs;
    unsigned jobs = 1;
    unsigned determinism_jobs = 0;
    std::vector<StageRun> stages;
    Usage usage;
    OutputReport output;
};

template <class Visitor, FieldsOf<CookReport> R>
void describe(Visitor& visit, R& r) {
    visit.field("schema", r.schema, "name and version of this form");
    visit.field("tool_version", r.tool_version, "of crumple");
    visit.field("exit_code", r.exit_code, "0: cooked; else see the table of exit codes");
    visit.field("error", r.error, "what stopped it, empty when cooked");
    visit.field("stopped_in", r.stopped_in,
                "the stage that ran then, or check_determinism, or write; empty when cooked");
    visit.field("recipe", r.recipe, "as given");
    visit.field("params", r.params, "effective parameters of every stage");
    visit.field("inputs", r.inputs, "what was read");
    visit.field("jobs", r.jobs, "threads");
    visit.field("determinism_jobs", r.determinism_jobs,
                "threads of the second cook that gave the same bytes, 0: none was run");
    visit.field("stages", r.stages, "in the order they ran");
    visit.field("usage", r.usage, "of the whole");
    visit.field("output", r.output, "the file");
}

// Fills the report as it goes, so that a cook that throws leaves what is known in it. A result that fails a gate is put
// beside the output, which stays as it was; then throws Error(quality).
void cook(const Recipe& recipe, const CookRequest& request, CookReport& report, const Observer& observer = {});

// What a cook would do, without doing it.
struct DryRunReport {
    std::string schema = "crumple/dry_run/1";
    bool would_change = true;
    std::vector<std::string> reasons;
    std::vector<std::string> stages;
};

template <class Visitor, FieldsOf<DryRunReport> R>
void describe(Visitor& visit, R& r) {
    visit.field("schema", r.schema, "name and version of this form");
    visit.field("would_change", r.would_change, "the output is not there or was made from something else");
    visit.field("reasons", r.reasons, "why");
    visit.field("stages", r.stages, "that would run, in order");
}

// Compares what the output says about itself with what a cook would put there. Throws as import for inputs that are
// missing, of no format that is read, or whose header, counts, indices or numbers are wrong; what only assimp or a
// later stage would find it does not see. A damaged output is a reason.
[[nodiscard]] DryRunReport dry_run(const Recipe& recipe, const CookRequest& request);

}
