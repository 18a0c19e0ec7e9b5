// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <set>

#include "pipeline/cook.h"
#include "pipeline/input_digests.h"
#include "pipeline/version.h"
#include "report/json_writer.h"
#include "store/read_file.h"

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
    const auto same_name = [](const auto& a, const auto& b) { return a.name == b.name; };
    if (reasons.empty() && !std::equal(now.begin(), now.end(), old.input_digests.begin(), same_name))
        reasons.push_back("the visual meshes came in another order");
}

void compare_contents(const Workspace& old, const CookRequest& request, std::vector<std::string>& reasons) {
    if (old.bundle && old.bundle->provenance.tool_version != tool_version()) {
        reasons.push_back("crumple changed from version " + old.bundle->provenance.tool_version + " to " +
                          std::string(tool_version()));
    }
    if (old.tets.has_value() != request.contents.has_work) {
        reasons.push_back(request.contents.has_work ? "--keep-work: the output lacks the work groups"
                                                    : "the output holds work groups");
    }
    const store::FileReader file(store::read_file(request.output), request.output);
    if (file.layout("/cook/record") == request.contents.layout) return;
    const bool wants_chunks = request.contents.layout == store::Layout::compressed;
    reasons.push_back(std::string("--layout changed from ") +
                      (wants_chunks ? "contiguous to chunked" : "chunked to contiguous"));
}

std::set<std::string> component_names(const Workspace& old) {
    std::set<std::string> names;
    const auto record =
        std::find_if(old.records.begin(), old.records.end(), [](const auto& r) { return r.name == "import"; });
    const Json report = report::parse_json(record->report.text, "import", {.kind = ErrorKind::bad_input});
    const Json* components = report.find("components");
    if (!components || !components->get_if<Json::List>()) return names;
    for (const Json& component : *components->get_if<Json::List>()) {
        const Json* name = component.find("name");
        if (const auto* text = name ? name->get_if<std::string>() : nullptr) names.insert(*text);
    }
    return names;
}

// Whether objects of these names give components of those: the second one of a name is "name.2".
bool explain(const std::vector<std::string>& objects, const std::set<std::string>& components) {
    return std::all_of(components.begin(), components.end(), [&](const std::string& component) {
        return std::any_of(objects.begin(), objects.end(), [&](const std::string& object) {
            if (component == object) return true;
            const bool is_numbered = component.starts_with(object + ".") &&
                                     component.find_first_not_of("0123456789", object.size() + 1) == std::string::npos;
            return is_numbered && components.contains(object);
        });
    });
}

// A file that does not name its objects has components, and so regions, named after itself. The bundle does not know
// what the file was called, so where its name alone does not explain them it is read.
void compare_names(const Workspace& old, const CookRequest& request, const importer::Params& params,
                   std::vector<std::string>& reasons) {
    const std::set<std::string> components = component_names(old);
    const std::string stem = std::filesystem::path(request.sources.shell).stem().string();
    if (explain({stem}, components) || explain(importer::shell_object_names(request.sources, params), components))
        return;
    reasons.push_back("the shell's file was renamed: what it does not name is now '" + stem + "'");
}

}

DryRunReport dry_run(const Recipe& recipe, const CookRequest& request) {
    DryRunReport report;
    for (const Stage& stage : stage_table()) report.stages.emplace_back(stage.name);
    const auto& params = recipe.params[stage_index("import")].as<importer::Params>();
    importer::look_at_inputs(request.sources, params);
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
        compare_contents(old, request, report.reasons);
        if (report.reasons.empty()) compare_names(old, request, params, report.reasons);
    } catch (const Error& error) {
        report.reasons.push_back(std::string("the output cannot be read: ") + error.what());
    }
    report.would_change = !report.reasons.empty();
    return report;
}

}
