// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/baseline.h"

#include <filesystem>
#include <span>

#include "core/error.h"
#include "pipeline/bundle_gates.h"
#include "pipeline/exit_codes.h"
#include "report/json_reader.h"
#include "report/json_writer.h"
#include "report/text_view.h"
#include "store/read_file.h"
#include "store/write_file.h"

namespace crumple::pipeline {

namespace {

std::string asset_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

bool has_figures(const FileCheck& check) { return check.figures.shape.tets > 0; }

// The first figure that is 0, which could not be compared; null: none. Only a mesh that cannot be simulated has such.
const char* missing_in(const gates::Baseline& figures) {
    if (figures.tets == 0) return "tets";
    if (!(figures.volume > 0)) return "volume";
    if (figures.pcg_soft == 0) return "pcg_soft";
    return figures.pcg_stiff == 0 ? "pcg_stiff" : nullptr;
}

gates::Limits limits_of(const FileCheck& check) {
    const auto told = told_gates(check.record);
    return told ? told->params.limits : gates::Limits();
}

}

BaselineFile load_baseline(const std::string& path, bool will_be_updated) {
    BaselineFile baseline;
    if (will_be_updated && !std::filesystem::exists(path)) return baseline;
    const std::vector<std::byte> bytes = store::read_file(path);
    report::read_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path,
                      report::Described::of(baseline));
    if (baseline.schema != BaselineFile().schema)
        throw Error(ErrorKind::usage, path + ": schema: '" + baseline.schema + "' is not " + BaselineFile().schema);
    for (const auto& [name, figures] : baseline.assets) {
        const char* missing = missing_in(figures);
        if (will_be_updated || !missing) continue;
        throw Error(ErrorKind::usage,
                    path + ": assets." + name + "." + missing +
                        ": no asset has 0, so nothing could be compared; run crumple check --update-baseline");
    }
    return baseline;
}

void check_asset_names(const std::vector<std::string>& paths) {
    std::map<std::string, std::string> known;
    for (const std::string& path : paths) {
        const auto [other, is_new] = known.try_emplace(asset_of(path), path);
        if (is_new) continue;
        throw Error(ErrorKind::usage, other->second + " and " + path + ": a baseline knows both as '" + other->first +
                                          "'; give one another name, or a baseline of its own");
    }
}

void compare_with(const BaselineFile& baseline, FileCheck& check) {
    if (!has_figures(check)) return;
    const auto known = baseline.assets.find(asset_of(check.path));
    if (known == baseline.assets.end()) {
        check.findings.push_back({"BASELINE_MISSING",
                                  Severity::warning,
                                  "the baseline does not know '" + asset_of(check.path) +
                                      "'; run crumple check --update-baseline once it is good",
                                  1,
                                  {}});
        return;
    }
    for (Finding& finding : gates::judge_against(known->second, check.figures, limits_of(check)))
        check.findings.push_back(std::move(finding));
    if (check.exit_code == exit_ok && report::has_severity(check.findings, Severity::error))
        check.exit_code = exit_quality;
}

void update_baseline(const std::string& path, BaselineFile baseline, const std::vector<FileCheck>& checks) {
    for (const FileCheck& check : checks) {
        const gates::Baseline figures = gates::baseline_of(check.figures);
        if (check.exit_code == exit_ok && !missing_in(figures)) baseline.assets[asset_of(check.path)] = figures;
    }
    const std::string json = report::write_json(report::Described::of(baseline));
    store::write_file(path, std::as_bytes(std::span(json)));
}

}
