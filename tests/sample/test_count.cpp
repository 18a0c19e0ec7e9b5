// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/count.h"

#include <gtest/gtest.h>
#include <regex.h>

#include <cmath>
#include <string>

#include "core/error.h"

using namespace crumple;
using namespace crumple::sample;

namespace {

TEST(Count, AnythingButTheThreeFormsIsRefusedWithWhatCanBeWritten) {
    for (const char* text : {"",        " ",
                             "Auto",    "auto ",
                             "-1",      "+5",
                             "5.0",     "1e3",
                             "5 ",      " 5",
                             "0x10",    "tets:",
                             "tets:-3", "tets: 5",
                             "tets",    "points:5",
                             "5,000",   "99999999999999999999999",
                             "1000001", "tets:1000001",
                             "tets:0",  "tets:00"}) {
        try {
            (void)parse_count(text);
            ADD_FAILURE() << '"' << text << '"';
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::usage);
            const std::string message = error.what();
            EXPECT_NE(message.find('"' + std::string(text) + '"'), std::string::npos) << message;
            EXPECT_NE(message.find("\"tets:5000\""), std::string::npos) << message;
        }
    }
}

bool is_read(const std::string& text) {
    try {
        (void)parse_count(text);
        return true;
    } catch (const Error&) {
        return false;
    }
}

TEST(Count, TheSchemasPatternTakesWhatTheProgramTakes) {
    // Not std::regex: g++ 12 takes its insides for uninitialized where sanitizers look on.
    regex_t pattern;
    ASSERT_EQ(regcomp(&pattern, std::string(count_pattern.text).c_str(), REG_EXTENDED | REG_NOSUB), 0);
    for (const char* text : {"auto",         "Auto",    "",         "0",       "00",           "0007",
                             "999999",       "1000000", "01000000", "1000001", "9999999",      "00999999",
                             "tets:0",       "tets:00", "tets:1",   "tets:01", "tets:1000000", "tets:1000001",
                             "tets:9999999", "tets:",   "-1",       "1e3"})
        EXPECT_EQ(regexec(&pattern, text, 0, nullptr, 0) == 0, is_read(text)) << text;
    regfree(&pattern);
}

TEST(Count, TheThreeFormsAreRead) {
    EXPECT_EQ(parse_count("auto").kind, CountKind::automatic);
    EXPECT_EQ(parse_count("0").kind, CountKind::points);
    EXPECT_EQ(parse_count("0").number, 0u);
    EXPECT_EQ(parse_count("500").number, 500u);
    EXPECT_EQ(parse_count("1000000").number, 1'000'000u);
    EXPECT_EQ(parse_count("tets:5000").kind, CountKind::tets);
    EXPECT_EQ(parse_count("tets:5000").number, 5000u);
}

TEST(Count, TetsAndPointsAreTurnedIntoEachOther) {
    for (const std::uint64_t points : {0u, 1u, 370u, 50'000u}) {
        EXPECT_EQ(points_for_tets(751, expected_tets(751, points)), points);
    }
    EXPECT_EQ(points_for_tets(751, 100), 0u);
}

TEST(Count, ExpectedTetsAreThoseMeasured) {
    // Published runs on two shells with 0 to 1 742 interior points, finished.
    const auto off_by = [](std::uint64_t vertices, std::uint64_t points, double tets) {
        return std::fabs(static_cast<double>(expected_tets(vertices, points)) / tets - 1);
    };
    EXPECT_LT(off_by(751, 0, 2105), 0.1);
    EXPECT_LT(off_by(751, 370, 4227), 0.1);
    EXPECT_LT(off_by(751, 1480, 10837), 0.1);
    EXPECT_LT(off_by(999, 1742, 13040), 0.1);
}

}
