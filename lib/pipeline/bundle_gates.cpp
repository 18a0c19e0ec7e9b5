// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/bundle_gates.h"

#include <algorithm>

#include "cull/cull.h"
#include "report/json_reader.h"

namespace crumple::pipeline {

namespace {

const StageRecord* find_record(const std::vector<StageRecord>& records, std::string_view stage) {
    const auto record = std::find_if(records.begin(), records.end(), [&](const auto& r) { return r.name == stage; });
    return record == records.end() ? nullptr : &*record;
}

constexpr report::ReadRules of_records{.kind = ErrorKind::bad_input, .allows_null = true};

gates::Solid solid_of(const std::vector<StageRecord>& records) {
    const StageRecord* record = find_record(records, "cull");
    if (!record || record->version != cull::version) return {};
    cull::Report told;
    report::read_json(record->report.text, "report of cull", report::Described::of(told), of_records);
    return {told.shell_volume, told.leak_share, told.shell_pieces};
}

}

gates::Report judge_cooked(const Workspace& work, const gates::Params& params, const Context& context) {
    return gates::judge_bundle(*work.bundle, *work.asset, solid_of(work.records), params, context);
}

std::optional<ToldGates> told_gates(const std::vector<StageRecord>& records) {
    const StageRecord* record = find_record(records, "gates");
    if (!record || record->version != gates::version) return std::nullopt;
    ToldGates told;
    report::read_json(record->params.text, "parameters of gates", report::Described::of(told.params), of_records);
    report::read_json(record->report.text, "report of gates", report::Described::of(told.report), of_records);
    return told;
}

std::string error_codes(std::span<const Finding> findings) {
    std::string codes;
    for (const Finding& finding : findings) {
        if (finding.severity == Severity::error) codes += (codes.empty() ? "" : ", ") + finding.code;
    }
    return codes;
}

std::string refused_by(const Workspace& work) {
    const std::optional<ToldGates> told = told_gates(work.records);
    return told ? error_codes(told->report.findings) : "";
}

GateCheck check_gates(const Workspace& work) {
    GateCheck check;
    std::optional<ToldGates> told = told_gates(work.records);
    check.was_asked = told.has_value();
    if (told) {
        check.params = told->params;
    } else {
        check.params.enforce = false;
    }
    if (work.asset) {
        check.shell = ShellFigures::measured;
        check.report = judge_cooked(work, check.params, {});
    } else {
        check.shell = told ? ShellFigures::stored : ShellFigures::none;
        check.report = gates::judge_again(*work.bundle, told ? told->report : gates::Report(), check.params);
    }
    return check;
}

}
