// SPDX-License-Identifier: MIT
// What differs between two files, dataset by dataset.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/fields.h"
#include "store/hdf5_file.h"

namespace crumple::store {

enum class Difference {
    only_in_first,
    only_in_second,
    type,  // of its elements
    shape,
    values,
};
inline constexpr EnumName<Difference> difference_names[] = {{Difference::only_in_first, "only_in_first"},
                                                            {Difference::only_in_second, "only_in_second"},
                                                            {Difference::type, "type"},
                                                            {Difference::shape, "shape"},
                                                            {Difference::values, "values"}};
constexpr std::span<const EnumName<Difference>> enum_names(Difference) { return difference_names; }

struct DatasetDifference {
    std::string path;  // an attribute is "<group>@<name>"
    Difference kind = Difference::values;
    std::uint64_t elements = 0;   // that differ
    std::uint64_t first_row = 0;  // with a difference
    double largest = 0;           // |a - b| of numbers; infinite where only one is not finite; 0 for texts
    std::uint64_t largest_row = 0;
    std::string first_value;  // of the element at first_row, in each file
    std::string second_value;
};

struct Comparison {
    std::uint64_t compared = 0;                // datasets and attributes
    std::vector<DatasetDifference> differing;  // by path: the first is the first differing dataset
};

// Compares what lies under `group` ("/" for all), apart from /digest. NaN equals NaN of the same bits, -0 differs from
// 0.
[[nodiscard]] Comparison compare_files(const FileReader& first, const FileReader& second,
                                       const std::string& group = "/bundle");

template <class Visitor, FieldsOf<DatasetDifference> D>
void describe(Visitor& visit, D& d) {
    visit.field("path", d.path, "dataset, or <group>@<attribute>");
    visit.field("kind", d.kind, "what differs");
    visit.field("elements", d.elements, "elements that differ");
    visit.field("first_row", d.first_row, "first row with a difference");
    visit.field("largest", d.largest, "largest absolute difference of numbers");
    visit.field("largest_row", d.largest_row, "row of the largest difference");
    visit.field("first_value", d.first_value, "first differing element in the first file");
    visit.field("second_value", d.second_value, "first differing element in the second file");
}

template <class Visitor, FieldsOf<Comparison> C>
void describe(Visitor& visit, C& c) {
    visit.field("compared", c.compared, "datasets and attributes compared");
    visit.field("differing", c.differing, "those that differ, by path");
}

}
