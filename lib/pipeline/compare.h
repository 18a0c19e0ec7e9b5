// SPDX-License-Identifier: GPL-3.0-or-later
// What differs between two files of ours, dataset by dataset.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/fields.h"

namespace crumple::pipeline {

struct Difference {
    std::string path;         // of a dataset, or "<group>@<attribute>"; empty: nothing differs
    std::string what;         // "values", "type or shape"
    std::uint64_t count = 0;  // values that differ
    std::uint64_t row = 0;    // of the first of them (largest: of the largest)
    std::uint64_t column = 0;
    std::string a;
    std::string b;
    double size = 0;  // largest |a - b| of the dataset; 0 where it holds no numbers
};

template <class Visitor, FieldsOf<Difference> D>
void describe(Visitor& visit, D& d) {
    visit.field("path", d.path, "dataset, or <group>@<attribute>; empty: nothing differs");
    visit.field("what", d.what, "values, or type or shape");
    visit.field("count", d.count, "values that differ");
    visit.field("row", d.row, "of the first of them; under largest: of the largest");
    visit.field("column", d.column, "of that value");
    visit.field("a", d.a, "that value in the first file");
    visit.field("b", d.b, "that value in the second file");
    visit.field("size", d.size, "largest |a - b| of the dataset");
}

struct CompareReport {
    std::string schema = "crumple/compare/1";
    bool is_equal = true;
    std::uint64_t compared = 0;
    std::uint64_t differing = 0;
    std::vector<std::string> only_in_a;
    std::vector<std::string> only_in_b;
    Difference first;
    Difference largest;
};

template <class Visitor, FieldsOf<CompareReport> R>
void describe(Visitor& visit, R& r) {
    visit.field("schema", r.schema, "name and version of this form");
    visit.field("is_equal", r.is_equal, "both hold the same");
    visit.field("compared", r.compared, "datasets and attributes that both have");
    visit.field("differing", r.differing, "how many of those differ");
    visit.field("only_in_a", r.only_in_a, "that only the first file has");
    visit.field("only_in_b", r.only_in_b, "that only the second file has");
    visit.field("first", r.first, "the first that differs: the bundle's before the rest, then by path");
    visit.field("largest", r.largest, "the one with the largest difference of numbers");
}

// Throws Error(bad_input) for an image that is damaged.
[[nodiscard]] CompareReport compare_images(std::vector<std::byte> a, const std::string& name_a,
                                           std::vector<std::byte> b, const std::string& name_b);

// In a child process with limits. Throws Error(file), or Error(difference) for a damaged file.
[[nodiscard]] CompareReport compare_files(const std::string& a, const std::string& b);

}
