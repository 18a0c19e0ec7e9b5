// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/prescan.h"

#include <string>
#include <string_view>
#include <vector>

#include "importer/import_checks.h"

namespace crumple::formats {
namespace {

using test::bad_input_of;
using test::contains;

std::string obj_message(std::string_view text, Purpose purpose = Purpose::shell) {
    return bad_input_of([&] { (void)prescan_obj(text, purpose); });
}

TEST(PrescanObj, RefusesAFileWithoutVertices) {
    EXPECT_TRUE(contains(obj_message(""), "no `v` line"));
    EXPECT_TRUE(contains(obj_message("vn 0 0 1\nvt 0 0\n"), "no `v` line"));
}

TEST(PrescanObj, RefusesWhatHoldsNoFaces) {
    EXPECT_TRUE(contains(obj_message("v 0 0 0\np 1\n"), "no faces, only points"));
    EXPECT_TRUE(contains(obj_message("v 0 0 0\ncurv 0 1 1 1\n"), "free-form"));
    EXPECT_EQ(prescan_obj("v 0 0 0\nf 1 1 1\ncurv 0 1 1 1\nsurf 0 1 0 1 1\n", Purpose::shell).unread.free_form, 2u);
}

TEST(PrescanObj, RefusesMoreNamesThanAssimpTellsApartInSeconds) {
    for (const std::string keyword : {"o", "usemtl"}) {
        std::string text = "v 0 0 0\nf 1 1 1\n";
        for (int i = 0; i < 40000; ++i) text += keyword + " name" + std::to_string(i) + "\n";
        EXPECT_TRUE(contains(obj_message(text), "too many objects and materials")) << keyword;
    }
    std::string few = "v 0 0 0\nf 1 1 1\n";
    for (int i = 0; i < 40000; ++i)
        few += "usemtl name" + std::to_string(i % 100) + "\ng part" + std::to_string(i) + "\n";
    EXPECT_EQ(obj_message(few), "");
}

TEST(PrescanObj, NamesTheFirstLineThatDiffers) {
    EXPECT_EQ(obj_message("v 0 0 0\nv 1 0 0\nf 1 2 1\n"), "");
    EXPECT_EQ(obj_message("v 0 0 0 1 1 1\nv 1 0 0 0 0 0\nf 1 2 1\n"), "");
    EXPECT_TRUE(contains(obj_message("# c\n\nv 0 0 0\nv 1 0 0 0 0 0\nv 1 2 3 0 0 0\n"), "line 4: a `v` line of 6"));
    EXPECT_TRUE(contains(obj_message("v 0 0 0 1 0 0\nv 1 0 0\n"), "line 2: a `v` line of 3"));
    EXPECT_TRUE(contains(obj_message("v 0 0 0 1\n"), "line 1: a `v` line of 4"));
    EXPECT_TRUE(contains(obj_message("v 0 0\n"), "line 1: a `v` line of 2"));
    EXPECT_TRUE(contains(obj_message("v 0 0 0 1 1 1 1\n"), "line 1: a `v` line of 7"));
}

TEST(PrescanObj, AVisualMeshMayMixAllFormsOfPaint) {
    const std::string text = "o a\nv 0 0 0\nv 1 0 0 0 red 0\nv 1 2 3 0 0 0 1\nv 4 5 6 1.0\nf 1 2 \\\n3\n";
    const Prescan scan = prescan_obj(text, Purpose::visual);
    EXPECT_EQ(scan.surface_only, "o a\nv 0 0 0\nv 1 0 0\nv 1 2 3\nv 4 5 6\nf 1 2 3\n");
    EXPECT_EQ(scan.positions.size(), 4u);
    EXPECT_TRUE(contains(obj_message("v 0 0 0 2\n", Purpose::visual), "line 1")) << "a weight is no paint";
    EXPECT_TRUE(contains(obj_message("v 0 0 0 1 1\n", Purpose::visual), "line 1"));
    EXPECT_TRUE(contains(obj_message(text), "line 3: a `v` line of 6"));
}

TEST(PrescanObj, HandsOnSurfaceAndPaintInPlainNumbers) {
    const Prescan scan = prescan_obj(
        "# path C:\\dir\\\n  v .5 -.25 1. .5 0 1 # 1\n\tv 1e0 +2 3 .0 .0 .0\nvt 0 0\nvn 0 0 1\nv 0 0 1e-3 1 1 1\n"
        "mtllib a.mtl\n  usemtl  steel \n f 1/1/1 -2//1 3 # 1\nl 1 2 3\np 1 2\ns off\n",
        Purpose::shell);
    EXPECT_EQ(scan.surface_only,
              "v 0.5 -0.25 1 0.5 0 1\nv 1 2 3 0 0 0\nv 0 0 0.001 1 1 1\nmtllib a.mtl\nusemtl steel \nf 1 2 3\n");
    EXPECT_EQ(scan.reds, (std::vector<float>{0.5f, 0, 1}));
    EXPECT_EQ(scan.unread.points_and_lines, 4u);
    EXPECT_EQ(scan.expected_triangles, 1u);
}

TEST(PrescanObj, RefusesColoursThatAssimpReadsAsSomethingElse) {
    const auto red = [](const std::string& word) { return obj_message("v 0 0 0 " + word + " 1 1\nf 1 1 1\n"); };
    for (const char* word : {"0", "0.5", "+1", "1e-3", "nan", "-nan(ind)", "255"}) EXPECT_EQ(red(word), "") << word;
    for (const char* word : {"-1.#IND", "1.#QNAN", "red", "0x0", "1,5"})
        EXPECT_TRUE(contains(red(word), "line 1: the colour '")) << word;
    EXPECT_TRUE(contains(obj_message("v 0 0 0 1 1 x\nf 1 1 1\n"), "line 1: the colour 'x'"));
}

TEST(PrescanObj, RefusesACarriageReturnWithinALine) {
    EXPECT_TRUE(contains(obj_message("v 0 0 0\nv 1\r 0 0\n"), "line 2: a carriage return"));
    EXPECT_TRUE(contains(obj_message("# a\rv 0 0 0\nv 1 0 0\n", Purpose::visual), "line 1: a carriage return"));
}

TEST(PrescanObj, CountsPolypaint) {
    EXPECT_EQ(prescan_obj("v 0 0 0\nv 1 0 0\n#MRGB ff000000ffffffff\n#MRGB ff0000\nf 1 2 1\n", Purpose::shell)
                  .unread.polypaint,
              2u);
}

TEST(PrescanObj, CountsLinesThroughContinuationsCommentsAndCarriageReturns) {
    EXPECT_EQ(obj_message("v 0 0 \\\n0\r\n  \tv 1\t2 3 # red\r\nf 1 2 1\r\n"), "");
    EXPECT_TRUE(contains(obj_message("v 0 \\\n0 0\nv 1 2 3 4 5 6\n"), "line 3:"));
}

TEST(PrescanObj, RefusesWhatIsNoNumber) {
    EXPECT_TRUE(contains(obj_message("v 0 zero 0\n"), "'zero' is not a number"));
    EXPECT_TRUE(contains(obj_message("v 0 1,5 0\n"), "'1,5' is not a number"));
    EXPECT_TRUE(contains(obj_message("v 0 \x01\xff 0\n"), "'?\?' is not a number"));
}

TEST(PrescanObj, ReadsTheNearestFloat) {
    const Prescan scan = prescan_obj("v -1.50856 +0.1 1e-6\nf 1 1 1 1\nf 1/1/1 1//1 1\n", Purpose::shell);
    EXPECT_EQ(scan.positions.at(0), (Vec3f{-1.50856f, 0.1f, 1e-6f}));
    EXPECT_EQ(scan.expected_triangles, 3u);
}

TEST(PrescanNumbers, KnowsWhatAssimpMakesOfThem) {
    const Prescan scan = prescan_numbers("<p>-1.69704 1.5e-6,0.25</p>");
    ASSERT_EQ(scan.numbers.size(), 3u);
    EXPECT_EQ(scan.numbers[0].exact, -1.69704f);
    EXPECT_EQ(scan.numbers[2].exact, 0.25f);
    EXPECT_EQ(scan.numbers[2].read, 0.25f);
    EXPECT_TRUE(prescan_numbers(std::string_view("1 2 3\0 4", 8)).numbers.empty());
}

}
}
