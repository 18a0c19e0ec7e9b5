// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/runner.h"

#include <algorithm>

#include "pipeline/cook_record.h"
#include "report/json_writer.h"
#include "report/text_view.h"

namespace crumple::pipeline {

namespace {

// Stages of other versions of the tool count as coming last.
std::size_t place_of(const std::string& name) {
    const auto table = stage_table();
    const auto stage = std::find_if(table.begin(), table.end(), [&](const Stage& s) { return s.name == name; });
    return static_cast<std::size_t>(stage - table.begin());
}

// The stage that first makes a group: what to run when it is missing.
std::string_view maker_of(Group group) {
    const auto table = stage_table();
    return std::find_if(table.begin(), table.end(), [&](const Stage& s) { return s.writes == group; })->name;
}

void require_inputs(const Stage& stage, const Workspace& work) {
    for (const Group group : stage.reads) {
        if (has_group(work, group)) continue;
        throw Error(ErrorKind::bad_input,
                    std::string(stage.name) + ": there is no /" + std::string(name_of(group)) +
                        (work.bundle ? " in it; crumple cook --keep-work leaves it in the bundle"
                                     : " yet; run crumple " + std::string(maker_of(group)) + " first"));
    }
    // A stage that changes what it reads wants it as the stages before it left it.
    const bool changes = std::find(stage.reads.begin(), stage.reads.end(), stage.writes) != stage.reads.end();
    for (const StageRecord& record : work.records) {
        const std::size_t place = place_of(record.name);
        if (!changes || place < place_of(std::string(stage.name)) || place >= stage_table().size()) continue;
        if (stage_table()[place].writes != stage.writes) continue;
        throw Error(ErrorKind::bad_input,
                    std::string(stage.name) + ": /" + std::string(name_of(stage.writes)) + " has been through " +
                        record.name + " already; start again from crumple " + std::string(maker_of(stage.writes)));
    }
}

Context context_for(const Stage& stage, unsigned jobs, const Observer& observer, const UsageMeter& meter) {
    Context context;
    context.jobs = jobs;
    if (observer.progress) {
        context.progress = [&stage, &observer, &meter](std::string_view step, double fraction) {
            observer.progress(stage, step, fraction, meter);
        };
    }
    if (observer.log) context.log = [&stage, &observer](std::string_view message) { observer.log(stage, message); };
    return context;
}

void keep_record(const report::OwnedDescribed& params, const StageRun& run, Workspace& work) {
    std::erase_if(work.records, [&](const StageRecord& r) { return place_of(r.name) >= place_of(run.name); });
    work.records.push_back(
        {run.name, run.version, {report::write_json(params.view(), report::JsonStyle::compact)}, run.report});
}

}

bool StageRun::is_rejected() const {
    return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
        return finding.severity == Severity::error && finding.code.starts_with("GATE_");
    });
}

StageRun run_stage(const Stage& stage, const report::OwnedDescribed& params, Workspace& work, unsigned jobs,
                   const Observer& observer) {
    require_inputs(stage, work);
    if (observer.begin) observer.begin(stage);
    const UsageMeter meter;
    const report::OwnedDescribed stage_report = stage.run(work, params, context_for(stage, jobs, observer, meter));
    StageRun run{std::string(stage.name), stage.version, meter.read(), {}, report::findings_of(stage_report.view())};
    run.report.text = report::write_json(stage_report.view(), report::JsonStyle::compact);
    drop_after(work, stage.writes);
    keep_record(params, run, work);
    if (stage.writes == Group::bundle) work.bundle->provenance = provenance_of(work);
    if (observer.end) observer.end(stage, run, stage_report.view());
    return run;
}

}
