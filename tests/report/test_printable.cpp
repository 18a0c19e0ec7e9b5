// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/printable.h"

#include <gtest/gtest.h>

using crumple::report::printable;
using crumple::report::shortened;

TEST(Printable, NothingStaysNothing) { EXPECT_EQ(printable(""), ""); }

TEST(Printable, WordsOfAnyLanguageStayAsTheyAre) { EXPECT_EQ(printable("Tür 車 \\ 🚗"), "Tür 車 \\ 🚗"); }

TEST(Printable, NothingDrivesATerminal) {
    EXPECT_EQ(printable("a\nb\tc\r"), "a\\nb\\tc\\r");
    EXPECT_EQ(printable("\x1b[31mred\x7f"), "\\x1b[31mred\\x7f");
    EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\xc2\\x9b31m")
        << "C1 controls in UTF-8";
    EXPECT_EQ(printable("\x9b"
                        "31m"),
              "\\x9b31m")
        << "and as a bare byte";
    EXPECT_EQ(printable("\xc3"), "\\xc3");
}

TEST(Printable, AShortTextIsNotCut) { EXPECT_EQ(shortened("key", 3), "key"); }

TEST(Printable, ALongTextLosesItsMiddleAndSaysSo) {
    const std::string text = "first" + std::string(100000, 'x') + "last";
    const std::string cut = shortened(text, 60);
    EXPECT_LT(cut.size(), 90u);
    EXPECT_TRUE(cut.starts_with("first"));
    EXPECT_TRUE(cut.ends_with("last"));
    EXPECT_NE(cut.find("(100009 bytes)"), std::string::npos);
}

TEST(Printable, CharactersAreNotCutInHalf) {
    std::string text;
    for (int i = 0; i < 200; ++i) text += "ä";
    for (std::size_t longest = 20; longest < 40; ++longest) {
        const std::string cut = shortened(text, longest);
        EXPECT_EQ(printable(cut), cut);
    }
}
