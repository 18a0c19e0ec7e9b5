// SPDX-License-Identifier: GPL-3.0-or-later
// What differs between two files of ours: `crumple compare`.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/fields.h"
#include "store/compare_files.h"

namespace crumple::pipeline {

struct CompareReport {
    std::string schema = "crumple/compare/1";
    bool is_equal = true;
    std::uint64_t compared = 0;
    std::string first;    // path; empty: nothing differs
    std::string largest;  // path; empty: no numbers differ
    double largest_size = 0;
    std::vector<store::DatasetDifference> differing;
};

template <class Visitor, FieldsOf<CompareReport> R>
void describe(Visitor& visit, R& r) {
    visit.field("schema", r.schema, "name and version of this form");
    visit.field("is_equal", r.is_equal, "both hold the same");
    visit.field("compared", r.compared, "datasets and attributes compared");
    visit.field("first", r.first, "the first that differs: the bundle's before the rest, then by path; empty: none");
    visit.field("largest", r.largest, "the one with the largest difference of numbers; empty: none");
    visit.field("largest_size", r.largest_size, "that difference");
    visit.field("differing", r.differing, "all that differ, the first first");
}

// Throws Error(bad_input) for an image that is damaged.
[[nodiscard]] CompareReport compare_images(std::vector<std::byte> a, const std::string& name_a,
                                           std::vector<std::byte> b, const std::string& name_b);

// In a child process with limits. Throws Error(file), Error(usage) for a blob, or Error(difference) for a damaged file.
[[nodiscard]] CompareReport compare_files(const std::string& a, const std::string& b);

[[nodiscard]] std::string compare_text(const CompareReport& report);

}
