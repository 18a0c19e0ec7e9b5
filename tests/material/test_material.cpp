// SPDX-License-Identifier: MIT
#include "material/material.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

using crumple::Material;

TEST(Material, NanIsOutOfEveryRange) {
    Material material;
    material.density_kg_m3 = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(crumple::first_field_out_of_range(material).find("density_kg_m3"), std::string::npos);
}

TEST(Material, NamesTheFirstFieldOutOfRangeAndItsLimits) {
    Material material;
    material.young_pa = -1;
    material.poisson = 0.5;
    EXPECT_EQ(crumple::first_field_out_of_range(material), "young_pa is -1, allowed are 1 to 1e+13");
}

TEST(Material, DefaultsAreInRange) { EXPECT_EQ(crumple::first_field_out_of_range(Material{}), ""); }

namespace {
struct NameList {
    std::vector<std::string> names;
    void field(std::string_view name, const std::string&, std::string_view) { names.emplace_back(name); }
    void field(std::string_view name, double, crumple::Range, std::string_view) { names.emplace_back(name); }
};
}

TEST(Material, DescribesEveryFieldOnce) {
    NameList list;
    const Material material;
    describe(list, material);
    // A string and nine doubles: a field added to the struct but not to describe() changes the size.
    EXPECT_EQ(list.names.size(), 1 + (sizeof(Material) - sizeof(std::string)) / sizeof(double));
}
