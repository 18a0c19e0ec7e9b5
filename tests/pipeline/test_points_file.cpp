// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/points_file.h"

#include <gtest/gtest.h>

#include "core/error.h"

using crumple::Error;
using crumple::ErrorKind;
using crumple::Vec3;
using crumple::pipeline::parse_node_points;
using crumple::pipeline::parse_obj_points;
using crumple::pipeline::parse_points;

namespace {

std::string refusal(std::string_view text) {
    try {
        (void)parse_points(text, "points.xyz");
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << text;
    return {};
}

const std::vector<Vec3> two{{1, 2, 3}, {-4, 0.5, 6e-3}};

}

TEST(PointsFile, AnEmptyTextHasNoPoints) {
    EXPECT_TRUE(parse_points("", "x").positions.empty());
    EXPECT_TRUE(parse_points("\n\n# only a comment\n", "x").positions.empty());
}

TEST(PointsFile, EverySeparatorIsTaken) {
    EXPECT_EQ(parse_points("1 2 3\n-4 .5 6e-3\n", "x").positions, two);
    EXPECT_EQ(parse_points("1,2,3\n-4,0.5,0.006", "x").positions, two);
    EXPECT_EQ(parse_points("1;2;3\r\n-4;0.5;0.006\r\n", "x").positions, two);
    EXPECT_EQ(parse_points("\t1\t2\t3\n  -4 , +0.5 ; 6E-3\n", "x").positions, two);
}

TEST(PointsFile, AHeadingACountAndAByteOrderMarkAreSkipped) {
    EXPECT_EQ(parse_points("x,y,z\n1,2,3\n-4,0.5,0.006\n", "x").positions, two);
    EXPECT_EQ(parse_points("2\n1 2 3\n-4 0.5 0.006\n", "x").positions, two);
    EXPECT_EQ(parse_points("\xef\xbb\xbf# made here\n1 2 3\n-4 0.5 0.006\n", "x").positions, two);
}

TEST(PointsFile, NoneOfThePointsIsTheShells) { EXPECT_EQ(parse_points("1 2 3", "x").shell_vertex_count, 0u); }

TEST(PointsFile, DoublesKeepTheirDigits) {
    EXPECT_EQ(parse_points("0.1 0.30000000000000004 1e-300", "x").positions[0],
              (Vec3{0.1, 0.30000000000000004, 1e-300}));
}

TEST(PointsFile, MinusZeroBecomesZero) { EXPECT_FALSE(std::signbit(parse_points("-0 0 0", "x").positions[0].x)); }

TEST(PointsFile, ALineThatIsNoPointIsNamed) {
    EXPECT_NE(refusal("1 2 3\n1 2\n").find("points.xyz:2:"), std::string::npos);
    EXPECT_NE(refusal("1 2 3\n\n1 2 x\n").find("points.xyz:3:"), std::string::npos);
    EXPECT_NE(refusal("1 2 3\n1 2 nan\n").find("not finite"), std::string::npos);
    EXPECT_NE(refusal("1 2 inf\n").find("not finite"), std::string::npos);
    EXPECT_NE(refusal("1 2 1e999\n").find("points.xyz:1:"), std::string::npos);
    EXPECT_NE(refusal("5\n1 2 3\n").find("promises 5"), std::string::npos);
    EXPECT_NE(refusal("x y z\nx y z\n").find("points.xyz:2:"), std::string::npos);
}

TEST(PointsFile, DecimalCommasAndOtherColumnsAreNotGuessedAt) {
    EXPECT_NE(refusal("1.5 2.5 3.5\n1,5 2,5 3,5\n").find("points.xyz:2: numbers with decimal commas"),
              std::string::npos);
    EXPECT_NE(refusal("1,5;2,5;3,5\n").find("points.xyz:1: numbers with decimal commas"), std::string::npos);
    EXPECT_NE(refusal("1 2 3\n1 2 3 4\n").find("points.xyz:2: 4 columns"), std::string::npos);
    EXPECT_NE(refusal("1 2 3 red\n").find("points.xyz:1: 4 columns"), std::string::npos);
    EXPECT_NE(refusal("1,5,2\n4,5,6,7\n").find("points.xyz:2: 4 columns"), std::string::npos);
    EXPECT_NE(refusal("one 2 3\n").find("'one'"), std::string::npos);
}

TEST(PointsFile, AnObjGivesItsVertices) {
    EXPECT_EQ(parse_obj_points("# c\nv 1 2 3 1 0 0\nvn 0 0 1\nv -4 0.5 0.006\nf 1 2 1\n", "x").positions, two);
    EXPECT_THROW((void)parse_obj_points("v 1 2\n", "x"), Error);
}

TEST(PointsFile, ANodeFileGivesItsPoints) {
    EXPECT_EQ(parse_node_points("2 3 0 1\n1 1 2 3 0\n2 -4 0.5 0.006 1\n# end", "x").positions, two);
    EXPECT_THROW((void)parse_node_points("", "x"), Error);
    EXPECT_THROW((void)parse_node_points("3 3 0 0\n1 1 2 3\n", "x"), Error);
    EXPECT_THROW((void)parse_node_points("18446744073709551615 3 0 0\n1 1 2 3\n", "x"), Error);
}

TEST(PointsFile, ExtensionsAreKnownInAnyCase) {
    EXPECT_TRUE(crumple::pipeline::is_points_file("a/b.XYZ"));
    EXPECT_TRUE(crumple::pipeline::is_points_file("b.csv"));
    EXPECT_FALSE(crumple::pipeline::is_points_file("b.hdf"));
    EXPECT_FALSE(crumple::pipeline::is_points_file("b"));
}
