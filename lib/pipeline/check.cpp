// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/check.h"

#include "bundle/blob.h"
#include "gates/shape_problems.h"
#include "pipeline/check_provenance.h"
#include "pipeline/exit_codes.h"
#include "pipeline/in_child.h"
#include "pipeline/work_file.h"
#include "report/printable.h"
#include "report/text_view.h"
#include "store/check_file.h"
#include "store/read_file.h"

namespace crumple::pipeline {

namespace {

// The findings a stored report holds. A report of another version of the stage may have another form, but findings are
// the same in all of them.
std::vector<Finding> findings_in(const StageRecord& record) {
    const report::Json json = report::parse_json(record.report.text, record.name, {.kind = ErrorKind::bad_input});
    const report::Json* list = json.find("findings");
    std::vector<Finding> findings;
    if (!list) return findings;
    report::read_json(report::dump_json(*list, report::JsonStyle::compact), record.name + " findings",
                      report::Described::of(findings), {.kind = ErrorKind::bad_input, .allows_null = true});
    return findings;
}

std::string without_name(const std::string& message, const std::string& name) {
    return message.starts_with(name + ": ") ? message.substr(name.size() + 2) : message;
}

// A work file that has not come to a bundle yet: shapes only, and nothing fails.
void measure_tets(const TetMesh& tets, FileCheck& check) {
    check.figures.shape = quality::summarize(tets);
    check.findings = gates::find_problems(tets, check.figures.shape);
}

void ask_gates(const Workspace& work, bool from_blob, FileCheck& check) {
    GateCheck gates = check_gates(work);
    check.figures = gates.report.figures;
    check.findings = std::move(gates.report.findings);
    check.shell = gates.shell;
    if (report::has_severity(check.findings, Severity::error)) check.exit_code = exit_quality;
    if (gates.was_asked) return;
    check.findings.push_back({"GATES_NOT_ASKED",
                              Severity::info,
                              from_blob
                                  ? "a blob carries no record of quality gates, so none fails it; check the bundle it "
                                    "was exported from"
                                  : "it was not held against quality gates when it was cooked, so none fails it now",
                              1,
                              {}});
}

bool stop_at_problems(FileCheck& check) {
    if (check.problems.empty()) return false;
    check.exit_code = exit_difference;
    check.error = check.problems.front().code + ": " + check.problems.front().message;
    return true;
}

}

FileCheck check_image(std::vector<std::byte> image, const std::string& name) {
    FileCheck check;
    check.path = name;
    const bool from_blob = is_blob(image);
    if (!from_blob) {
        store::CheckedFile checked = store::check_file(image, name);
        check.digest = std::move(checked.digest);
        check.problems = std::move(checked.findings);
    }
    if (stop_at_problems(check)) return check;
    const Workspace work = read_work_image(std::move(image), name);
    if (work.bundle) check.problems = check_provenance(work);
    if (stop_at_problems(check)) return check;
    if (work.bundle) {
        ask_gates(work, from_blob, check);
        for (Finding& finding : tell_of_newer(work.bundle->provenance)) check.findings.push_back(std::move(finding));
    } else if (work.tets) {
        measure_tets(*work.tets, check);
    }
    for (const StageRecord& record : work.records) {
        std::vector<Finding> findings = findings_in(record);
        if (!findings.empty()) check.stages.push_back({record.name, std::move(findings)});
    }
    check.record = work.records;
    return check;
}

FileCheck check_file(const std::string& path) {
    try {
        const std::vector<std::byte> image = store::read_file(path);
        // Reading is quick; trying what a mesh costs takes its time where it is large and bad.
        const double time_s = 120 + 10e-6 * static_cast<double>(image.size());
        return run_described_in_child<FileCheck>([&] { return check_image(image, path); }, path, time_s);
    } catch (const Error& error) {
        FileCheck check;
        check.path = path;
        const bool is_damage = error.kind() == ErrorKind::bad_input || error.kind() == ErrorKind::usage;
        check.exit_code = is_damage ? exit_difference : exit_code_of(error.kind());
        check.error = error.what();
        return check;
    }
}

namespace {

std::string failure_text(const FileCheck& check, const std::string& name, bool has_color) {
    const std::string verdict = name + (check.exit_code == exit_difference ? ": DAMAGED" : ": ERROR");
    if (check.problems.empty())
        return verdict + ": " +
               report::printable(report::shortened(without_name(check.error, check.path), report::longest_message)) +
               "\n";
    return verdict + "\n" + report::findings_text(check.problems, {has_color, 2, max_places});
}

std::string verdict_text(const FileCheck& check, const std::string& name) {
    std::vector<Finding> all = check.findings;
    // What the gates told then is told again by what they say now.
    for (const StageFindings& stage : check.stages) {
        if (stage.stage != "gates") all.insert(all.end(), stage.findings.begin(), stage.findings.end());
    }
    const char* verdict = check.exit_code == exit_quality
                              ? ": GATE NOT MET; every digest right, every invariant holds; "
                              : ": ok, every digest right, every invariant holds; ";
    return name + verdict + report::findings_summary(all) + "\n";
}

}

std::string check_text(const FileCheck& check, bool has_color, bool is_verbose) {
    const std::string name = report::printable(report::shortened(check.path, report::longest_message));
    const std::size_t places = is_verbose ? max_places : 0;
    if (check.exit_code != exit_ok && check.exit_code != exit_quality) return failure_text(check, name, has_color);
    std::string text = verdict_text(check, name);
    const std::size_t shown = check.exit_code == exit_quality ? max_places : places;
    text += report::findings_text(check.findings, {has_color, 2, shown});
    for (const StageFindings& stage : check.stages) {
        if (stage.stage == "gates") continue;
        text += "  while cooking, " + report::printable(stage.stage) + ":\n" +
                report::findings_text(stage.findings, {has_color, 4, places});
    }
    if (is_verbose) text += "  figures\n" + report::report_text(report::Described::of(check.figures), {.indent = 4});
    return text;
}

}
