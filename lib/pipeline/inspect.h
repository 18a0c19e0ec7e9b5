// SPDX-License-Identifier: GPL-3.0-or-later
// What a file of ours holds: `crumple inspect`.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "bundle/summary.h"
#include "pipeline/cook_record.h"
#include "pipeline/workspace.h"
#include "quality/figures.h"

namespace crumple::pipeline {

struct DatasetReport {
    std::string path;
    std::string type;
    std::vector<std::uint64_t> shape;
};

template <class Visitor, FieldsOf<DatasetReport> R>
void describe(Visitor& visit, R& r) {
    visit.field("path", r.path, "in the file");
    visit.field("type", r.type, "of the elements");
    visit.field("shape", r.shape, "rows first");
}

struct InspectReport {
    std::string schema = "crumple/inspect/1";
    std::uint64_t bytes = 0;
    std::string sha256;
    std::vector<Group> groups;
    BundleSummary bundle;  // zeros where there is none
    bool has_figures = false;
    quality::Figures figures;
    CookRecord record;
    std::vector<DatasetReport> datasets;
};

template <class Visitor, FieldsOf<InspectReport> R>
void describe(Visitor& visit, R& r) {
    visit.field("schema", r.schema, "name and version of this form");
    visit.field("bytes", r.bytes, "size of the file");
    visit.field("sha256", r.sha256, "of the file's bytes");
    visit.field("groups", r.groups, "parts the file holds");
    visit.field("bundle", r.bundle, "what a game loads; zeros where there is no bundle");
    visit.field("has_figures", r.has_figures, "the file has been through the gates");
    visit.field("figures", r.figures, "its quality as measured then; zeros where it was not");
    visit.field("record", r.record, "how it came to be");
    visit.field("datasets", r.datasets, "every array of the file");
}

// Throws Error(bad_input) for a damaged image.
[[nodiscard]] InspectReport inspect_image(std::vector<std::byte> image, const std::string& name);

// In a child process with limits. Throws Error(file), or Error(difference) for a damaged file.
[[nodiscard]] InspectReport inspect_file(const std::string& path);

// Free text for a terminal.
[[nodiscard]] std::string inspect_text(const InspectReport& report, bool lists_datasets);

}
