// SPDX-License-Identifier: MIT
#include "core/utf8.h"

#include <gtest/gtest.h>

using crumple::is_control;
using crumple::utf8_size;

TEST(Utf8, NoTextHasNoCharacter) { EXPECT_EQ(utf8_size(""), 0u); }

TEST(Utf8, WellFormedCharactersHaveTheirSize) {
    EXPECT_EQ(utf8_size("a"), 1u);
    EXPECT_EQ(utf8_size(std::string_view("\0", 1)), 1u);
    EXPECT_EQ(utf8_size("\xc3\xa4x"), 2u);
    EXPECT_EQ(utf8_size("\xe2\x82\xac"), 3u);
    EXPECT_EQ(utf8_size("\xf0\x9f\x9a\x97"), 4u);
}

TEST(Utf8, ControlCharactersDoNotShow) {
    for (const char* control : {"\x01", "\n", "\x7f", "\xc2\x85", "\u061c", "\u200e", "\u200f", "\u2028", "\u202a",
                                "\u202e", "\u2066", "\u2069"})
        EXPECT_TRUE(is_control(control)) << control;
    for (const char* shown :
         {"a", " ", "\xc2\xa0", "\u00e4", "\u061b", "\u200d", "\u2010", "\u202f", "\u206a", "\U0001f697"})
        EXPECT_FALSE(is_control(shown)) << shown;
}

TEST(Utf8, EverythingElseIsNone) {
    for (const char* text : {"\x80", "\xc3", "\xc3(", "\xc0\xaf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                             "\xf8\x88\x80\x80\x80", "\xe2\x82", "\xff"}) {
        EXPECT_EQ(utf8_size(text), 0u) << text;
    }
}
