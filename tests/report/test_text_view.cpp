// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/text_view.h"

#include <gtest/gtest.h>

#include "report/example_params.h"
#include "report/number_text.h"

using crumple::Finding;
using crumple::none;
using crumple::nowhere;
using crumple::Severity;
using crumple::report::Described;
using crumple::report::findings_of;
using crumple::report::findings_summary;
using crumple::report::findings_text;
using crumple::report::float_text;
using crumple::report::has_severity;
using crumple::report::number_text;
using crumple::report::report_text;
using crumple::report::size_text;
using crumple::report::table_text;

TEST(TextView, NoFindingsSayNothing) {
    EXPECT_EQ(findings_text({}), "");
    EXPECT_EQ(findings_summary({}), "no findings");
}

TEST(TextView, FindingsAreSortedBySeverityAndNameTheirPlaces) {
    const std::vector<Finding> findings{
        {"NOTE", Severity::info, "fyi", 1, {}},
        {"SHELL_OPEN", Severity::error, "close it", 3, {{{1, 2, 3}, 7, "hood"}, {{4, 5, 6}, crumple::none, ""}}}};
    EXPECT_EQ(findings_text(findings, {.places = 3}),
              "error SHELL_OPEN (3): close it\n    at (1, 2, 3) #7 'hood'\n    at (4, 5, 6)\ninfo NOTE: fyi\n");
    EXPECT_EQ(findings_summary(findings), "1 error, 1 note");
    EXPECT_TRUE(has_severity(findings, Severity::error));
    EXPECT_FALSE(has_severity(findings, Severity::warning));
}

TEST(TextView, NamesFromFilesCannotDriveTheTerminal) {
    const std::vector<Finding> findings{{"A", Severity::info, "a\033[31m", 1, {{{}, 7, "x\ny"}}}};
    EXPECT_EQ(findings_text(findings), "info A: a\\x1b[31m\n    at (0, 0, 0) #7 'x\\ny'\n");
}

TEST(TextView, APlaceWithoutAPositionIsToldByItsName) {
    const std::vector<Finding> findings{{"A", Severity::info, "a", 1, {{nowhere, none, "/bundle/mass"}}},
                                        {"B", Severity::info, "b", 1, {{nowhere, none, ""}}}};
    EXPECT_EQ(findings_text(findings), "info A: a\n    at '/bundle/mass'\ninfo B: b\n");
}

TEST(TextView, AReportIsOneLinePerField) {
    example::Params params;
    params.roles["hood"] = example::Method::odt;
    const std::string text = report_text(Described::of(params));
    EXPECT_NE(text.find("sweeps     20\n"), std::string::npos) << text;
    EXPECT_NE(text.find("element    -\n"), std::string::npos) << text;
    EXPECT_NE(text.find("box\n  low   (-1, -1, -1)\n"), std::string::npos) << text;
    EXPECT_NE(text.find("roles\n  hood  odt\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("findings"), std::string::npos) << text;
}

TEST(TextView, AListOfPlainStructsIsATable) {
    example::Params params;
    params.sensors.resize(2);
    const std::string text = report_text(Described::of(params));
    EXPECT_NE(text.find("sensors\n  low           high\n  (-1, -1, -1)  (1, 1, 1)\n"), std::string::npos) << text;
}

TEST(TextView, TablesAlign) {
    EXPECT_EQ(table_text({{"stage", "tets"}, {"relax", "7"}, {"cull", "12345"}}),
              "stage   tets\nrelax      7\ncull   12345\n");
}

TEST(TextView, FindingsOfAReportAreFoundByType) {
    example::Params params;
    params.findings.resize(2);
    EXPECT_EQ(findings_of(Described::of(params)).size(), 2u);
    const example::Box box;
    EXPECT_TRUE(findings_of(Described::of(box)).empty());
}

TEST(NumberText, SaysSizesInPowersOfAThousand) {
    EXPECT_EQ(size_text(999), "999 B");
    EXPECT_EQ(size_text(1000), "1 kB");
    EXPECT_EQ(size_text(999999), "1 MB");
    EXPECT_EQ(size_text(5900000), "5.9 MB");
    EXPECT_EQ(number_text(1.0 / 3), "0.333333");
    EXPECT_EQ(float_text(0.1f), "0.1");
}
