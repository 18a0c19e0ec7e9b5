// SPDX-License-Identifier: MIT
#include "core/names.h"

#include <gtest/gtest.h>

#include <vector>

using crumple::list_names;
using crumple::nearest_name;

TEST(Names, NothingIsNearWhenNothingIsValid) { EXPECT_EQ(nearest_name("sweeps", {}), ""); }

TEST(Names, ATypoFindsItsName) {
    const std::vector<std::string> valid{"method", "sweeps", "stop_movement", "samples"};
    EXPECT_EQ(nearest_name("sweep", valid), "sweeps");
    EXPECT_EQ(nearest_name("swepes", valid), "sweeps");
    EXPECT_EQ(nearest_name("Sweeps", valid), "sweeps");
    EXPECT_EQ(nearest_name("stop-movement", valid), "stop_movement");
    EXPECT_EQ(nearest_name("", valid), "method");
    EXPECT_FALSE(nearest_name(std::string(100000, 'x'), valid).empty());
}

TEST(Names, ALongListIsCut) {
    EXPECT_EQ(list_names(std::vector<std::string>{"a", "b"}), "a, b");
    const std::string text = list_names(std::vector<std::string>(100, "x"));
    EXPECT_EQ(text.substr(text.size() - 5), ", ...");
}
