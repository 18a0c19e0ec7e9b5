// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/check.h"

#include "bundle/blob.h"
#include "pipeline/export_mesh.h"
#include "pipeline/in_child.h"
#include "pipeline/work_file.h"
#include "report/printable.h"
#include "report/text_view.h"
#include "store/check_file.h"
#include "store/read_file.h"

namespace crumple::pipeline {

namespace {

constexpr int damaged = 7;

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

void measure_quality(const Workspace& work, FileCheck& check) {
    if (!work.bundle && !work.tets) return;
    Bundle bundle = visible_bundle(work);
    TetMesh tets;
    for (const Vec3f p : bundle.rest_positions) tets.positions.push_back({p.x, p.y, p.z});
    tets.tets = std::move(bundle.tets);
    tets.region = std::move(bundle.region);
    check.quality = quality::summarize(tets);
    for (Finding& finding : quality::find_problems(tets, check.quality)) check.findings.push_back(std::move(finding));
}

}

FileCheck check_image(std::vector<std::byte> image, const std::string& name) {
    FileCheck check;
    check.path = name;
    if (!is_blob(image)) {
        store::CheckedFile checked = store::check_file(image, name);
        check.digest = std::move(checked.digest);
        check.problems = std::move(checked.findings);
    }
    if (!check.problems.empty()) {
        check.exit_code = damaged;
        check.error = check.problems.front().code + ": " + check.problems.front().message;
        return check;
    }
    const Workspace work = read_work_image(std::move(image), name);
    measure_quality(work, check);
    check.shell = shell_figures(work);
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
        return run_described_in_child<FileCheck>([&] { return check_image(image, path); }, path);
    } catch (const Error& error) {
        FileCheck check;
        check.path = path;
        check.exit_code = error.kind() == ErrorKind::file ? 2 : error.kind() == ErrorKind::internal ? 5 : damaged;
        check.error = error.what();
        return check;
    }
}

std::string check_text(const FileCheck& check, bool has_color, bool is_verbose) {
    const std::string name = report::printable(check.path);
    const std::size_t places = is_verbose ? max_places : 0;
    if (check.exit_code != 0) {
        const std::string verdict = name + (check.exit_code == damaged ? ": DAMAGED" : ": ERROR");
        if (check.problems.empty())
            return verdict + ": " + report::printable(without_name(check.error, check.path)) + "\n";
        return verdict + "\n" + report::findings_text(check.problems, {has_color, 2, max_places});
    }
    std::vector<Finding> all = check.findings;
    for (const StageFindings& stage : check.stages) all.insert(all.end(), stage.findings.begin(), stage.findings.end());
    std::string text =
        name + ": ok, every digest right, every invariant holds; " + report::findings_summary(all) + "\n";
    text += report::findings_text(check.findings, {has_color, 2, places});
    for (const StageFindings& stage : check.stages) {
        text += "  while cooking, " + report::printable(stage.stage) + ":\n" +
                report::findings_text(stage.findings, {has_color, 4, places});
    }
    if (is_verbose) text += "  shell\n" + report::report_text(report::Described::of(check.shell), {.indent = 4});
    if (is_verbose) text += "  quality\n" + report::report_text(report::Described::of(check.quality), {.indent = 4});
    return text;
}

}
