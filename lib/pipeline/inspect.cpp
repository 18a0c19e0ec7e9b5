// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/inspect.h"

#include "bundle/blob.h"
#include "bundle/validate.h"
#include "pipeline/bundle_gates.h"
#include "pipeline/in_child.h"
#include "pipeline/work_file.h"
#include "report/number_text.h"
#include "report/printable.h"
#include "report/text_view.h"
#include "store/read_file.h"
#include "store/sha256.h"

namespace crumple::pipeline {

namespace {

std::vector<DatasetReport> list_datasets(const store::FileReader& file) {
    std::vector<DatasetReport> list;
    for (const std::string& path : file.all_datasets()) {
        const store::DatasetInfo info = file.info(path);
        list.push_back({path, std::string(store::name_of(info.type)), info.shape});
    }
    return list;
}

std::string groups_text(const std::vector<Group>& groups) {
    std::string text;
    for (const Group group : groups) text += (text.empty() ? "/" : " /") + std::string(name_of(group));
    return text.empty() ? "none" : text;
}

std::string stages_text(const CookRecord& record) {
    std::string text;
    for (const StageRecord& stage : record.stages) {
        text += (text.empty() ? "" : ", ") + report::printable(stage.name) + " " + std::to_string(stage.version);
    }
    return text.empty() ? "none" : text;
}

std::string shape_text(const DatasetReport& dataset) {
    std::string text;
    for (const std::uint64_t extent : dataset.shape) text += (text.empty() ? "" : " x ") + std::to_string(extent);
    return text;
}

}

InspectReport inspect_image(std::vector<std::byte> image, const std::string& name) {
    InspectReport report;
    report.bytes = image.size();
    report.sha256 = store::to_hex(store::sha256(image));
    if (!is_blob(image)) report.datasets = list_datasets(store::FileReader(image, name));
    const Workspace work = read_work_image(std::move(image), name);
    for (const auto& group : group_names) {
        if (has_group(work, group.value)) report.groups.push_back(group.value);
    }
    if (work.bundle) {
        if (!validate(*work.bundle).empty())
            throw Error(ErrorKind::bad_input, name + ": the bundle is not valid; see crumple check");
        report.bundle = summarize(*work.bundle);
    }
    if (const auto told = told_gates(work.records)) {
        report.has_figures = true;
        report.figures = told->report.figures;
    }
    report.record = cook_record(work);
    return report;
}

InspectReport inspect_file(const std::string& path) {
    const std::vector<std::byte> image = store::read_file(path);
    return run_described_in_child<InspectReport>([&] { return inspect_image(image, path); }, path);
}

std::string inspect_text(const InspectReport& report, bool lists_datasets) {
    std::string text = "file     " + report::size_text(report.bytes) + ", SHA-256 " + report.sha256 + "\n";
    text += "groups   " + groups_text(report.groups) + "\n";
    text += "cooked   by crumple " + report::printable(report.record.tool_version) +
            "; stages: " + stages_text(report.record) + "\n";
    for (const InputRecord& input : report.record.inputs) {
        text += "input    " + report::printable(input.name) + ", SHA-256 " + report::printable(input.sha256) + "\n";
    }
    if (report.bundle.nodes > 0)
        text += "bundle\n" + report::report_text(report::Described::of(report.bundle), {.indent = 2});
    if (report.has_figures)
        text += "quality\n" + report::report_text(report::Described::of(report.figures), {.indent = 2});
    if (!lists_datasets) return text;
    std::vector<std::vector<std::string>> rows{{"dataset", "type", "shape"}};
    for (const DatasetReport& dataset : report.datasets)
        rows.push_back({report::printable(dataset.path), dataset.type, shape_text(dataset)});
    return text + report::table_text(rows);
}

}
