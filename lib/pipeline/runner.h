// SPDX-License-Identifier: GPL-3.0-or-later
// Runs stages on a workspace: measures them, keeps the record, and tells an observer what happens.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/context.h"
#include "pipeline/recipe.h"
#include "pipeline/stage_table.h"
#include "pipeline/usage.h"
#include "pipeline/workspace.h"

namespace crumple::pipeline {

// What one stage did. Unlike its StageRecord this differs from run to run.
struct StageRun {
    std::string name;
    int version = 0;
    Usage usage;
    report::RawJson report;
    std::vector<Finding> findings;
    // A gate failed: what came out is to be looked at, not used.
    [[nodiscard]] bool is_rejected() const;
};

template <class Visitor, FieldsOf<StageRun> R>
void describe(Visitor& visit, R& r) {
    visit.field("name", r.name, "stage");
    visit.field("version", r.version, "of the stage's method");
    visit.field("usage", r.usage, "what it cost");
    visit.field("report", r.report, "what it said; schemas/stage_<name>.schema.json");
    visit.field("findings", r.findings, "what a person should know");
}

struct Observer {
    std::function<void(const Stage&)> begin;
    std::function<void(const Stage&, std::string_view step, double fraction, const UsageMeter& since_begin)> progress;
    std::function<void(const Stage&, const StageRun&, report::Described report)> end;
    std::function<void(const Stage&, std::string_view message)> log;
};

// Throws Error(bad_input) when a part the stage reads is not there, or was made by a later stage already; else what the
// stage throws, its name in front.
[[nodiscard]] StageRun run_stage(const Stage& stage, const report::OwnedDescribed& params, Workspace& workspace,
                                 unsigned jobs, const Observer& observer = {});

}
