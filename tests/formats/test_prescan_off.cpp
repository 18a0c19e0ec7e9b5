// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/prescan.h"

#include <string>
#include <string_view>

#include "importer/import_checks.h"

namespace crumple::formats {
namespace {

using test::bad_input_of;
using test::contains;

std::string off_message(std::string_view text) {
    return bad_input_of([&] { (void)prescan_off(text, Purpose::shell); });
}

TEST(PrescanOff, CountsAreThoseOfTheLines) {
    EXPECT_EQ(off_message("OFF\n# c\n3 1 0\n0 0 0\n1 0 0\n\n0 1 0\n3 0 1 2\n"), "");
    EXPECT_EQ(off_message("COFF 3 1 0\n0 0 0 1 1 1 1\n1 0 0 0 0 0 1\n0 1 0 1 1 1 1\n3 0 1 2 255 0 0\n"), "");
    EXPECT_TRUE(contains(off_message(""), "empty"));
    EXPECT_TRUE(contains(off_message("PLY\n"), "OFF is missing"));
    EXPECT_TRUE(contains(off_message("4OFF\n1 0 0\n0 0 0 0\n"), "another dimension"));
    EXPECT_TRUE(contains(off_message("OFF\n3 1 0\n0 0 0\n1 0 0\n"), "ends after 2 of 3 vertices"));
    EXPECT_TRUE(contains(off_message("OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 1\n"), "ends after 0 of 1 faces"));
    EXPECT_TRUE(contains(off_message("OFF\n353000000000 1 0\n0 0 0\n"), "more than the file can hold"));
    EXPECT_TRUE(contains(off_message("OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 1\n3 0 1 3\n"), "line 6: corner 2"));
    EXPECT_TRUE(contains(off_message("OFF\n1 1 0\n0 0 0\n12 0 0 0 0 0 0 0 0 0 0 0 0\n"), "12 corners"));
    EXPECT_TRUE(contains(off_message("OFF\nmany 1 0\n0 0 0\n"), "not numbers"));
}

TEST(PrescanOff, RefusesNumbersTheFirstLineDoesNotAnnounce) {
    const auto file = [](const std::string& keyword, const std::string& more) {
        return keyword + "\n1 1 0\n0 0 0" + more + "\n3 0 0 0\n";
    };
    for (const auto& [keyword, more] : {std::pair<std::string, std::string>{"OFF", ""},
                                        {"COFF", " 255 0 0 255"},
                                        {"COFF # colours", " 1 0 0 1 # a comment"},
                                        {"NOFF", " 0 0 1"},
                                        {"STCOFF", " 1 0 0 1 0 0"}})
        EXPECT_EQ(off_message(file(keyword, more)), "") << keyword;
    for (const char* more : {" 255 0 0", " 255 0 0 255", " 1"})
        EXPECT_TRUE(contains(off_message(file("OFF", more)), "line 3: a vertex of ")) << more;
    for (const char* more : {"", " 255 0 0", " 255 0 0 255 1"})
        EXPECT_TRUE(contains(off_message(file("COFF", more)), "where 'COFF' has 7")) << more;
    for (const char* keyword : {"NCOFF", "CNOFF", "STCNOFF"})
        EXPECT_TRUE(contains(off_message(file(keyword, " 0 0 1 255 0 0 255")), "programs disagree")) << keyword;
    EXPECT_TRUE(contains(off_message(file("XOFF", "")), "no word of OFF"));
    EXPECT_TRUE(contains(off_message("OFF BINARY\n"), "binary OFF"));
}

TEST(PrescanOff, AVisualMeshMayBePaintedInAnyWay) {
    for (const auto& [keyword, more] : {std::pair<std::string, std::string>{"OFF", " 255 0 0"},
                                        {"COFF", ""},
                                        {"COFF", " x"},
                                        {"CNOFF", " 1 2 3 4 5 6 7"}}) {
        const Prescan scan =
            prescan_off(keyword + "\n3 1 0\n0 0 0.1" + more + "\n1 0 0\n-1e-9 1 0 1\n3 0 1 2 1 0 0\n", Purpose::visual);
        EXPECT_EQ(scan.surface_only, "OFF\n3 1 0\n0 0 0.1\n1 0 0\n-1e-09 1 0\n3 0 1 2\n") << keyword;
        EXPECT_TRUE(scan.reds.empty());
    }
    EXPECT_NE(bad_input_of([] { (void)prescan_off("4OFF\n1 0 0\n0 0 0 0\n", Purpose::visual); }), "");
    EXPECT_NE(bad_input_of([] { (void)prescan_off("OFF\n1 0 0\n0 0\n", Purpose::visual); }), "");
}

TEST(PrescanOff, CountsFacesThatHaveAColour) {
    const Prescan scan =
        prescan_off("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0 # red\n3 0 2 1 # none\n", Purpose::shell);
    EXPECT_EQ(scan.unread.colored_faces, 1u);
    EXPECT_EQ(scan.surface_only, "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n")
        << "without the colours of faces";
}

TEST(PrescanOff, HandsOnVerticesAndFacesWithoutComments) {
    const Prescan scan = prescan_off(
        "COFF # painted\n# by hand\n3 1 0\n0 0 0 0 .5 1 1 # a\n# b\n1 0 0 1 1 1 1\n\n0 .5 0 1 1 1 1\n# c\n3 0 1 2 # "
        "d\n",
        Purpose::shell);
    EXPECT_EQ(scan.surface_only, "COFF\n3 1 0\n0 0 0 0 .5 1 1\n1 0 0 1 1 1 1\n0 0.5 0 1 1 1 1\n3 0 1 2\n");
    EXPECT_EQ(scan.unread.colored_faces, 0u);
}

}
}
