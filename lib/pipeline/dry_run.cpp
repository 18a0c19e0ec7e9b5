// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>

#include "pipeline/cook.h"
#include "pipeline/input_digests.h"
#include "report/json_writer.h"

namespace crumple::pipeline {

namespace {

using report::Json;

void compare_json(const Json* old, const Json* now, const std::string& path, std::vector<std::string>& reasons) {
    const auto text = [](const Json* json) {
        return json ? report::dump_json(*json, report::JsonStyle::compact) : "nothing";
    };
    const auto* fields = now ? now->get_if<Json::Object>() : nullptr;
    if (fields && old && old->get_if<Json::Object>()) {
        for (const auto& [key, child] : *fields) compare_json(old->find(key), &child, path + "." + key, reasons);
        for (const auto& [key, child] : *old->get_if<Json::Object>()) {
            if (!now->find(key)) compare_json(&child, nullptr, path + "." + key, reasons);
        }
    } else if (text(old) != text(now)) {
        reasons.push_back(path + " changed from " + text(old) + " to " + text(now));
    }
}

void compare_stage(const Stage& stage, const report::OwnedDescribed& params, const Workspace& old,
                   std::vector<std::string>& reasons) {
    const auto record =
        std::find_if(old.records.begin(), old.records.end(), [&](const auto& r) { return r.name == stage.name; });
    const std::string name(stage.name);
    if (record == old.records.end()) {
        reasons.push_back("stage " + name + " did not run");
        return;
    }
    if (record->version != stage.version) {
        reasons.push_back("stage " + name + " changed from version " + std::to_string(record->version) + " to " +
                          std::to_string(stage.version));
    }
    const Json before = report::parse_json(record->params.text, name, {.kind = ErrorKind::bad_input});
    const Json now = report::build_json(params.view());
    compare_json(&before, &now, name, reasons);
}

using Digests = std::vector<BundleProvenance::Entry>;

void compare_inputs(const Workspace& old, const Digests& now, std::vector<std::string>& reasons) {
    for (const auto& input : now) {
        const auto before = std::find_if(old.input_digests.begin(), old.input_digests.end(),
                                         [&](const auto& d) { return d.name == input.name; });
        if (before == old.input_digests.end())
            reasons.push_back("input " + input.name + " is new");
        else if (before->value != input.value)
            reasons.push_back("input " + input.name + " changed");
    }
    for (const auto& before : old.input_digests) {
        const bool is_gone = std::none_of(now.begin(), now.end(), [&](const auto& d) { return d.name == before.name; });
        if (is_gone) reasons.push_back("input " + before.name + " is gone");
    }
}

}

DryRunReport dry_run(const Recipe& recipe, const CookRequest& request) {
    DryRunReport report;
    for (const Stage& stage : stage_table()) report.stages.emplace_back(stage.name);
    importer::look_at_inputs(request.sources, recipe.params[stage_index("import")].as<importer::Params>());
    const Digests digests = digest_inputs(input_files(request.sources, recipe));
    if (!std::filesystem::exists(request.output)) {
        report.reasons.push_back("the output is not there");
        return report;
    }
    try {
        const Workspace old = read_work_file(request.output);
        compare_inputs(old, digests, report.reasons);
        for (std::size_t i = 0; i < stage_table().size(); ++i)
            compare_stage(stage_table()[i], recipe.params[i], old, report.reasons);
        if (old.tets.has_value() != request.contents.has_work) {
            report.reasons.push_back(request.contents.has_work ? "--keep-work: the output lacks the work groups"
                                                               : "the output holds work groups");
        }
    } catch (const Error& error) {
        report.reasons.push_back(std::string("the output cannot be read: ") + error.what());
    }
    report.would_change = !report.reasons.empty();
    return report;
}

}
