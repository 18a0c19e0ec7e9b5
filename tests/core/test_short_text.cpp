// SPDX-License-Identifier: MIT
#include "core/short_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

using crumple::percent_text;
using crumple::position_text;
using crumple::short_text;

TEST(ShortText, HasFewDigitsAndNoExponentThatAPersonWouldStumbleOver) {
    EXPECT_EQ(short_text(0), "0");
    EXPECT_EQ(short_text(100), "100");
    EXPECT_EQ(short_text(99.96, 2), "100");
    EXPECT_EQ(short_text(123456, 2), "123456");
    EXPECT_EQ(short_text(-1234.5), "-1234");
    EXPECT_EQ(short_text(0.25), "0.25");
    EXPECT_EQ(short_text(0.00001234), "0.0000123");
    EXPECT_EQ(short_text(1e-6), "0.000001");
    EXPECT_EQ(short_text(1.01e-7), "1.01e-07");
    EXPECT_EQ(short_text(1e9), "1e+09");
    EXPECT_EQ(short_text(std::numeric_limits<double>::infinity()), "inf");
    EXPECT_EQ(short_text(std::numeric_limits<double>::quiet_NaN()), "nan");
    EXPECT_EQ(short_text(std::numeric_limits<double>::max()), "1.8e+308");
}

TEST(ShortText, SharesAndPlaces) {
    EXPECT_EQ(percent_text(1), "100 %");
    EXPECT_EQ(percent_text(0.9999), "100 %");
    EXPECT_EQ(percent_text(0.02346), "2.35 %");
    EXPECT_EQ(position_text({0, 1e-8, -2.25}), "(0, 1e-08, -2.25)");
    EXPECT_EQ(position_text({1000000, 0.5, 1e-5}), "(1000000, 0.5, 0.00001)");
}

}
