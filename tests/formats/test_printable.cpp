// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/printable.h"

#include <gtest/gtest.h>

namespace crumple::formats {
namespace {

TEST(Printable, KeepsUtf8AndReplacesTheRest) {
    EXPECT_EQ(printable(""), "");
    EXPECT_EQ(printable("M\xc3\xb6hre \xe2\x82\xac \xf0\x9f\x9a\x97"), "M\xc3\xb6hre \xe2\x82\xac \xf0\x9f\x9a\x97");
    EXPECT_EQ(printable("\xc3"), "?");              // cut off
    EXPECT_EQ(printable("\xc0\x80"), "??");         // overlong
    EXPECT_EQ(printable("\xed\xa0\x80"), "?\?\?");  // surrogate
    EXPECT_EQ(printable("\xf5\x80\x80\x80"), "?\?\?\?");
    EXPECT_EQ(printable(std::string_view("a\0b\x7f", 4)), "a?b?");
    const std::string longest = printable(std::string(199, 'a').append("\xc3\xa4"));
    EXPECT_EQ(longest, std::string(199, 'a'));  // cut before the character that does not fit
}

}
}
