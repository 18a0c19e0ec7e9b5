// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/check_provenance.h"

#include <string>

#include "pipeline/cook_record.h"
#include "report/json.h"

namespace crumple::pipeline {

namespace {

Finding untrue(const std::string& what) { return {"BUNDLE_PROVENANCE", Severity::error, what, 1, {}}; }

// The recipe as one line of JSON in our own form; nothing where it is none.
std::optional<std::string> canonical(const std::string& recipe) {
    try {
        return report::dump_json(report::parse_json(recipe, "recipe"), report::JsonStyle::compact);
    } catch (const Error&) {
        return std::nullopt;
    }
}

}

std::vector<Finding> check_provenance(const Workspace& workspace) {
    const BundleProvenance& told = workspace.bundle->provenance;
    const std::optional<std::string> recipe = canonical(told.recipe);
    if (!recipe) return {untrue("the recipe it says it was made with is no JSON")};
    if (workspace.records.empty()) return {};
    const BundleProvenance recorded = provenance_of(workspace);
    std::vector<Finding> findings;
    if (*recipe != canonical(recorded.recipe))
        findings.push_back(untrue("the recipe it says it was made with is not that of its stages"));
    if (told.stage_versions != recorded.stage_versions)
        findings.push_back(untrue("the versions of stages it says it was made by are not those of its record"));
    if (told.input_digests != recorded.input_digests)
        findings.push_back(untrue("the digests of inputs it says it was made from are not those of its record"));
    return findings;
}

}
