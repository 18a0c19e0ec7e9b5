// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/check_provenance.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "pipeline/cook_record.h"
#include "pipeline/version.h"
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

// "1.20.3", and what a pre-release or build adds behind '-' or '+' [semver.org, 2.0.0].
std::optional<std::array<std::uint32_t, 3>> version_numbers(std::string_view version) {
    const std::size_t end = std::min(version.find_first_of("-+"), version.size());
    const std::string_view suffix = version.substr(end);
    const bool is_plain = std::all_of(suffix.begin(), suffix.end(), [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '-' ||
               c == '+';
    });
    if (!is_plain || suffix.size() == 1) return std::nullopt;
    std::array<std::uint32_t, 3> numbers{};
    const char* at = version.data();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0 && (at == version.data() + end || *at++ != '.')) return std::nullopt;
        const auto [next, error] = std::from_chars(at, version.data() + end, numbers[i]);
        if (error != std::errc{}) return std::nullopt;
        at = next;
    }
    return at == version.data() + end ? std::optional(numbers) : std::nullopt;
}

}

std::vector<Finding> tell_of_newer(const BundleProvenance& provenance) {
    const auto theirs = version_numbers(provenance.tool_version);
    if (!theirs || *theirs <= version_numbers(tool_version())) return {};
    return {{"BUNDLE_NEWER",
             Severity::info,
             "it was cooked by crumple " + provenance.tool_version + ", newer than this " +
                 std::string(tool_version()) +
                 "; the version of its format is known, what newer programs add is ignored",
             1,
             {}}};
}

std::vector<Finding> check_provenance(const Workspace& workspace) {
    const BundleProvenance& told = workspace.bundle->provenance;
    const std::optional<std::string> recipe = canonical(told.recipe);
    if (!version_numbers(told.tool_version))
        return {untrue("the version of crumple it says it was made by, '" + told.tool_version + "', is none")};
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
