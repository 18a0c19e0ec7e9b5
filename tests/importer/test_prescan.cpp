// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/prescan.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "importer/import_checks.h"

namespace crumple::importer {
namespace {

using test::contains;

template <class Function>
std::string message_of(Function&& function) {
    const auto refusal = test::refusal_of(function);
    EXPECT_TRUE(refusal.message.empty() || refusal.kind == ErrorKind::bad_input);
    return refusal.message;
}

std::string obj_message(std::string_view text, Purpose purpose = Purpose::shell) {
    return message_of([&] { (void)prescan_obj(text, purpose); });
}
std::string ply_message(const std::string& bytes, Purpose purpose = Purpose::shell) {
    return message_of([&] { (void)prescan_ply(bytes, purpose); });
}
std::string off_message(std::string_view text) {
    return message_of([&] { (void)prescan_off(text, Purpose::shell); });
}
std::string gltf_message(const std::string& text) {
    return message_of([&] { (void)prescan_gltf(text); });
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
    EXPECT_EQ(scan.surface_only, "o a\nv 0 0 0\nv 1 0 0\nv 1 2 3\nv 4 5 6\nf 1 2  3\n");
    EXPECT_EQ(scan.positions.size(), 4u);
    EXPECT_EQ(prescan_obj("v 0 0 0\nf 1 1 1\n", Purpose::visual).surface_only, "") << "read as it is";
    EXPECT_TRUE(contains(obj_message("v 0 0 0 2\n", Purpose::visual), "line 1")) << "a weight is no paint";
    EXPECT_TRUE(contains(obj_message("v 0 0 0 1 1\n", Purpose::visual), "line 1"));
    EXPECT_TRUE(contains(obj_message(text), "line 3: a `v` line of 6"));
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

std::string ply(const std::string& elements, const std::string& body, const std::string& format = "ascii") {
    return "ply\nformat " + format + " 1.0\ncomment x\n" + elements + "end_header\n" + body;
}
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string faces = "property list uchar int vertex_indices\n";

TEST(PrescanPly, AcceptsWhatIsComplete) {
    const std::string bytes =
        ply("element vertex 3\n" + xyz + "element face 1\n" + faces, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    const Prescan scan = prescan_ply(bytes, Purpose::shell);
    EXPECT_EQ(scan.positions.size(), 3u);
    EXPECT_EQ(scan.expected_triangles, 1u);
}

TEST(PrescanPly, RefusesPaintWhoseZeroTheReaderLoses) {
    for (const std::string type : {"char", "int8", "short", "int16", "int", "int32", "uint", "uint32"}) {
        const std::string file = ply("element vertex 1\n" + xyz + "property " + type + " red\n", "0 0 0 0\n");
        EXPECT_TRUE(contains(ply_message(file), "line 8: the vertex colour 'red' is of a ")) << type;
        EXPECT_EQ(ply_message(file, Purpose::visual), "") << type;
    }
    for (const std::string type : {"uchar", "ushort", "float", "double"})
        EXPECT_EQ(ply_message(ply("element vertex 1\n" + xyz + "property " + type + " red\n", "0 0 0 0\n")), "")
            << type;
}

TEST(PrescanPly, RefusesPaintUnderAnotherName) {
    const auto named = [](const std::string& name) {
        return ply("element vertex 1\n" + xyz + "property uchar " + name + "\n", "0 0 0 0\n");
    };
    for (const std::string name : {"Red", "RED", "R", "diffuse_red", "vertex_color", "rgb", "red_", "scalar_Rgb"}) {
        EXPECT_TRUE(
            contains(ply_message(named(name)), "line 8: the vertex property '" + name + "' looks like a colour"))
            << name;
        EXPECT_EQ(ply_message(named(name), Purpose::visual), "") << name;
    }
    for (const std::string name : {"red", "r", "intensity", "reduced", "radius", "color_index", "red_id"})
        EXPECT_EQ(ply_message(named(name)), "");
    EXPECT_TRUE(contains(ply_message(named("red\nproperty uchar red")), "both 'red' and then 'red'"));
    EXPECT_TRUE(contains(ply_message(named("red\nproperty uchar r")), "both 'red' and then 'r'"));
    EXPECT_TRUE(contains(
        ply_message(ply("element vertex 1\n" + xyz + "property list uchar uchar red\n", "0 0 0 1 0\n")), "is a list"));
}

TEST(PrescanPly, RefusesNumbersOfTextThatDoNotFitTheirType) {
    const auto red = [](const std::string& type, const std::string& value) {
        return ply_message(
            ply("element vertex 2\n" + xyz + "property " + type + " red\n", "0 0 0 0\n0 0 0 " + value + "\n"));
    };
    EXPECT_EQ(red("uchar", "255"), "");
    EXPECT_EQ(red("ushort", "256"), "");
    EXPECT_EQ(red("float", "-1"), "");
    for (const std::string value : {"-1", "256", "300", "0.5", "nan", "1e9"})
        EXPECT_TRUE(contains(red("uchar", value), "line 11: '" + value + "' in vertex 1 does not fit")) << value;
}

TEST(PrescanPly, AVisualMeshMayBePaintedInAnyWay) {
    for (const char* color : {"char red", "list uchar uchar red", "uchar red\nproperty uchar r", "float rgb"}) {
        const std::string header = "element vertex 1\n" + xyz + "property " + color + "\n";
        EXPECT_EQ(ply_message(ply(header, "0 0 0 1 -1.#IND\n"), Purpose::visual), "") << color;
        EXPECT_NE(ply_message(ply(header, "0 0 0 1 -1.#IND\n")), "") << color;
    }
    const Prescan scan =
        prescan_ply(ply("element vertex 1\n" + xyz + "property uchar red\n", "0 0 0 0\n"), Purpose::visual);
    EXPECT_TRUE(scan.reds.empty());
    EXPECT_FALSE(contains(scan.surface_only, "red"));
}

TEST(PrescanPly, ReadsElementsInAnyOrderAndAnyTypes) {
    const std::string camera = "element camera 1\nproperty float view_px\nproperty list uchar int more\n";
    const std::string face = "element face 1\nproperty uchar flags\n" + faces;
    const std::string vertex =
        "element vertex 3\nproperty uchar flags\nproperty double z\nproperty int y\nproperty float x\n"
        "property ushort red\nproperty float quality\n";
    const std::string rows = "-1 1 2 3 0 -1.#IND\n1.5 4 5 6 65535 nan\nx 7 8 9 13107 ?\n";
    const Prescan scan = prescan_ply(ply(camera + face + vertex, "0.5 2 7 -8\n-1 3 0 1 2\n" + rows), Purpose::shell);
    ASSERT_EQ(scan.positions.size(), 3u);
    EXPECT_EQ(scan.positions[1], (Vec3f{6, 5, 4}));
    EXPECT_EQ(scan.reds, (std::vector<float>{0, 1, 13107.0f / 65535.0f}));
    EXPECT_EQ(scan.expected_triangles, 1u);
    EXPECT_TRUE(contains(scan.surface_only, "element vertex 3\nproperty float x\n"));
    EXPECT_FALSE(contains(scan.surface_only, "camera"));
}

TEST(PrescanPly, ForgivesBlanksBehindTheLinesOfTheHeader) {
    const std::string text = "ply \nformat ascii 1.0 \t\r\nelement vertex 1 \n" + xyz + "end_header  \r\n1 2 3\n";
    EXPECT_EQ(prescan_ply(text, Purpose::shell).positions.at(0), (Vec3f{1, 2, 3}));
    EXPECT_TRUE(contains(ply_message("ply\rformat ascii 1.0\rend_header\r"), "line feeds"));
    EXPECT_TRUE(contains(ply_message("plywood\n"), "the word ply is missing"));
}

TEST(PrescanPly, ReadsWhatOldLibrariesPrintForWhatIsNoNumber) {
    const auto red = [](const std::string& word) {
        return prescan_ply(ply("element vertex 1\n" + xyz + "property float red\n", "0 0 0 " + word + "\n"),
                           Purpose::shell)
            .reds.at(0);
    };
    for (const char* word : {"-1.#IND", "1.#QNAN", "-1.#IND00", "1.#SNAN", "nan", "-nan(ind)"})
        EXPECT_TRUE(std::isnan(red(word))) << word;
    EXPECT_EQ(red("-1.#INF"), -std::numeric_limits<float>::infinity());
    EXPECT_TRUE(contains(ply_message(ply("element vertex 1\n" + xyz, "0 -1.#IND 0\n")), "coordinate y of vertex 0"));
    EXPECT_TRUE(contains(ply_message(ply("element vertex 1\n" + xyz, "0 -1.#IDEA 0\n")), "line 9: '-1.#IDEA'"));
}

TEST(PrescanPly, CountsFacesThatHaveAColour) {
    const auto colored = [](const std::string& property) {
        const std::string header =
            "element vertex 1\n" + xyz + "element face 1\n" + faces + "property " + property + "\n";
        return prescan_ply(ply(header, "0 0 0\n3 0 0 0 1\n"), Purpose::shell).unread.colored_faces;
    };
    EXPECT_EQ(colored("uchar red"), 1u);
    EXPECT_EQ(colored("float diffuse_red"), 1u);
    EXPECT_EQ(colored("int material_index"), 0u);
}

TEST(PrescanPly, RefusesElementsThatAreNoSurface) {
    EXPECT_TRUE(
        contains(ply_message(ply("element vertex 1\nproperty float x\nproperty float y\n", "0 0\n")), "x, y and z"));
    EXPECT_TRUE(contains(ply_message(ply("element vertex 1\nproperty list uchar float x\n", "0\n")), "'x' is a list"));
    EXPECT_TRUE(contains(ply_message(ply("element vertex 1\n" + xyz + "property float x\n", "0 0 0 0\n")), "both 'x'"));
    EXPECT_TRUE(
        contains(ply_message(ply("element vertex 0\n" + xyz + "element vertex 1\n" + xyz, "0 0 0\n")), "twice"));
    EXPECT_TRUE(
        contains(ply_message(ply("element vertex 1\n" + xyz + "element face 1\nproperty list uchar int corners\n",
                                 "0 0 0\n3 0 0 0\n")),
                 "no list 'vertex_indices'"));
}

TEST(PrescanPly, CountsWhatFollowsTheLastElement) {
    const std::string header = "element vertex 1\n" + xyz;
    EXPECT_EQ(prescan_ply(ply(header, "0 0 0\n\n \n"), Purpose::shell).unread.bytes, 0u);
    EXPECT_EQ(prescan_ply(ply(header, "0 0 0\n1 2 3"), Purpose::shell).unread.bytes, 5u);
    const std::string binary = ply(header, std::string(15, '\0'), "binary_little_endian");
    EXPECT_EQ(prescan_ply(binary, Purpose::shell).unread.bytes, 3u);
}

TEST(PrescanPly, RefusesBrokenHeaders) {
    EXPECT_TRUE(contains(ply_message(""), "ply"));
    EXPECT_TRUE(contains(ply_message("ply\n"), "end_header"));
    EXPECT_TRUE(contains(ply_message("ply\nelement vertex 1\nend_header\n"), "format"));
    EXPECT_TRUE(contains(ply_message(ply("element vertex 1\n" + xyz, "0 0 0\n", "binary_middle_endian")),
                         "binary_middle_endian"));
    EXPECT_TRUE(contains(ply_message(ply("element vertex many\n" + xyz, "")), "how many"));
    EXPECT_TRUE(contains(ply_message(ply("element vertex -1\n" + xyz, "")), "how many"));
    EXPECT_TRUE(contains(ply_message(ply("property float x\n", "")), "before any element"));
    EXPECT_TRUE(contains(ply_message(ply("element vertex 1\nproperty quad x\n", "0\n")), "'quad'"));
    EXPECT_TRUE(contains(ply_message(ply("element face 0\n", "")), "no element 'vertex'"));
    EXPECT_TRUE(contains(ply_message(ply("element vertex 1\nproperty list float int x\n", "1 1")), "real number"));
}

TEST(PrescanPly, RefusesTruncatedBodies) {
    const std::string header = "element vertex 2\n" + xyz + "element face 1\n" + faces;
    EXPECT_TRUE(contains(ply_message(ply(header, "0 0 0\n1 0 0\n3 0 1")), "ends within face 0"));
    EXPECT_TRUE(contains(ply_message(ply(header, "0 0 0\n1 0")), "ends within vertex 1 of 2"));
    EXPECT_TRUE(
        contains(ply_message(ply(header, std::string(20, '\0'), "binary_little_endian")), "ends within vertex 1 of 2"));
}

TEST(PrescanPly, RefusesAbsurdCountsAtOnce) {
    EXPECT_TRUE(contains(ply_message(ply("element vertex 18446744073709551615\n" + xyz, "0 0 0\n")), "only 6 bytes"));
    EXPECT_TRUE(
        contains(ply_message(ply("element vertex 1\n" + xyz + "element empty 1000000000000\n", "0 0 0\n")), "'empty'"));
}

TEST(PrescanPly, RefusesStripsAndMissingVertices) {
    EXPECT_TRUE(contains(
        ply_message(ply("element vertex 1\n" + xyz + "element tristrips 1\nproperty list int int vertex_indices\n",
                        "0 0 0\n1 0\n")),
        "strips"));
    EXPECT_TRUE(contains(ply_message(ply("element vertex 1\n" + xyz + "element face 1\n" + faces, "0 0 0\n3 0 0 1\n")),
                         "face 0 refers"));
    EXPECT_TRUE(contains(ply_message(ply("element vertex 1\n" + xyz + "element face 1\n" + faces, "0 0 0\n3 0 -1 0\n")),
                         "face 0 refers"));
}

TEST(PrescanPly, EveryTruncationOfABinaryFileIsRefused) {
    std::string body;
    for (int i = 0; i < 12; ++i) body += std::string("\0\0\x80\x3f", 4);
    body += std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
    const std::string whole =
        ply("element vertex 4\n" + xyz + "element face 1\n" + faces, body, "binary_little_endian");
    EXPECT_EQ(ply_message(whole), "");
    for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_NE(ply_message(whole.substr(0, size)), "") << size;
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
    EXPECT_NE(message_of([] { (void)prescan_off("4OFF\n1 0 0\n0 0 0 0\n", Purpose::visual); }), "");
    EXPECT_NE(message_of([] { (void)prescan_off("OFF\n1 0 0\n0 0\n", Purpose::visual); }), "");
}

TEST(PrescanOff, CountsFacesThatHaveAColour) {
    const Prescan scan =
        prescan_off("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0 # red\n3 0 2 1 # none\n", Purpose::shell);
    EXPECT_EQ(scan.unread.colored_faces, 1u);
    EXPECT_EQ(scan.surface_only, "");
}

TEST(PrescanGltf, RefusesOtherVersionsAndDamage) {
    EXPECT_TRUE(contains(gltf_message("{"), "JSON"));
    EXPECT_TRUE(contains(gltf_message("[]"), "JSON"));
    EXPECT_TRUE(contains(gltf_message("{}"), "version"));
    EXPECT_TRUE(contains(gltf_message(R"({"asset": {"version": "1.0"}})"), "'1.0'"));
    EXPECT_TRUE(contains(gltf_message(R"({"asset": {"version": 2}})"), "version"));
    EXPECT_EQ(gltf_message(R"({"asset": {"version": "2.0"}})"), "");
}

std::string gltf(const std::string& rest) { return R"({"asset": {"version": "2.0"}, )" + rest + "}"; }

TEST(PrescanGltf, RefusesAccessorsBeyondTheirBuffer) {
    const std::string buffer = R"("buffers": [{"byteLength": 36, "uri": "a.bin"}], )";
    const std::string view = R"("bufferViews": [{"buffer": 0, "byteLength": 36}], )";
    const auto accessor = [](int count) {
        return R"("accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": )" +
               std::to_string(count) + "}]";
    };
    EXPECT_EQ(gltf_message(gltf(buffer + view + accessor(3))), "");
    EXPECT_TRUE(contains(gltf_message(gltf(buffer + view + accessor(4))), "accessor 0 reaches beyond"));
    EXPECT_TRUE(contains(gltf_message(gltf(buffer + view + accessor(-1))), "count is not a size"));
    EXPECT_TRUE(
        contains(gltf_message(gltf(R"("buffers": [{"byteLength": 35, "uri": "a.bin"}], )" + view + accessor(3))),
                 "buffer view 0 reaches beyond"));
    EXPECT_TRUE(contains(gltf_message(gltf(view + accessor(3))), "refers to no buffer"));
    EXPECT_TRUE(contains(gltf_message(gltf(accessor(3))), "refers to no buffer view"));
    EXPECT_TRUE(
        contains(gltf_message(gltf(R"("accessors": [{"componentType": 7, "type": "VEC3"}])")), "component type 7"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("accessors": 3)")), "accessors is not a list"));
    EXPECT_TRUE(
        contains(gltf_message(gltf(R"("meshes": [{"primitives": [{"attributes": {"POSITION": 9}}]}])")), "accessor 9"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("nodes": [{"scale": [1, 2]}])")), "scale is not 3 numbers"));
}

TEST(PrescanGltf, RefusesWhatWouldBeReadAsNoise) {
    EXPECT_TRUE(contains(gltf_message(gltf(R"("extensionsRequired": ["EXT_meshopt_compression"])")),
                         "EXT_meshopt_compression"));
    EXPECT_EQ(gltf_message(gltf(R"("extensionsRequired": ["KHR_texture_transform"])")), "");
    EXPECT_TRUE(contains(gltf_message(gltf(R"("extensionsRequired": ["KHR_draco_mesh_compression"])")),
                         "compressed ('KHR_draco_mesh_compression')"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("extensionsRequired": ["ACME_secret"])")), "extension 'ACME_secret'"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("nodes": [{"extensions": {"EXT_mesh_gpu_instancing": {}}}])")),
                         "drawn many times"));
    const auto mesh = [](const std::string& accessors) {
        return gltf(R"("buffers": [{"byteLength": 36, "uri": "a.bin"}],
                       "bufferViews": [{"buffer": 0, "byteLength": 36}], "accessors": [)" +
                    accessors + R"(], "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}}]}])");
    };
    const std::string position = R"({"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3})";
    const std::string color = R"({"componentType": 5121, "type": "VEC4", "count": )";
    EXPECT_EQ(gltf_message(mesh(position + ", " + color + "3}")), "");
    EXPECT_TRUE(contains(gltf_message(mesh(position + ", " + color + "2}")), "COLOR_0 holds 2 colours for 3 vertices"));
    EXPECT_TRUE(contains(
        gltf_message(mesh(R"({"bufferView": 0, "componentType": 5122, "type": "VEC3", "count": 3}, )" + color + "3}")),
        "not three floats"));
    EXPECT_TRUE(contains(gltf_message(mesh(R"({"componentType": 5126, "type": "VEC3", "count": 3}, )" + color + "3}")),
                         "without a buffer"));
}

TEST(PrescanGltf, KnowsWhichExtensionsLeaveTheSurfaceAlone) {
    for (const char* name : {"KHR_texture_transform", "KHR_materials_unlit", "KHR_lights_punctual", "KHR_xmp_json_ld",
                             "KHR_animation_pointer", "EXT_mesh_features", "EXT_structural_metadata",
                             "MSFT_packing_normalRoughnessMetallic", "MSFT_lod", "AGI_articulations"}) {
        const Prescan scan = prescan_gltf(gltf(std::string(R"("extensionsRequired": [")") + name + "\"]"));
        EXPECT_EQ(scan.extensions, std::vector<std::string>{name});
    }
    for (const char* name : {"KHR_draco_mesh_compression", "KHR_mesh_quantization", "EXT_meshopt_compression",
                             "EXT_mesh_gpu_instancing", "KHR_gaussian_splatting", "KHR_", ""}) {
        EXPECT_TRUE(contains(gltf_message(gltf(std::string(R"("extensionsRequired": [")") + name + "\"]")), name))
            << name;
        EXPECT_NE(gltf_message(gltf(std::string(R"("extensionsRequired": [")") + name + "\"]")), "") << name;
    }
    EXPECT_TRUE(contains(gltf_message(gltf(R"("extensionsRequired": [7])")), "no text"));
}

TEST(PrescanGltf, ChoosesTheSceneThatIsRead) {
    const std::string nodes =
        R"("nodes": [{"mesh": 0}, {"children": [2]}, {"mesh": 0}], "meshes": [{"primitives": []}])";
    const auto scan = [&](const std::string& scenes) { return prescan_gltf(gltf(scenes + nodes)); };
    EXPECT_EQ(scan(R"("scenes": [{"nodes": [0, 1]}], )").unread.nodes, 0u);
    EXPECT_EQ(scan(R"("scenes": [{"nodes": [1]}, {"nodes": [0]}], )").unread.nodes, 1u);
    EXPECT_TRUE(
        contains(gltf_message(gltf(R"("scene": 1, "scenes": [{"nodes": [1]}, {}], )" + nodes)), "holds no mesh"));
    const Prescan all = scan(R"("scenes": [{"nodes": [2, 1, 0]}], )");
    EXPECT_TRUE(contains(all.surface_only, R"("scenes":[{"nodes":[1,0]}])")) << "2 is below 1";
    EXPECT_TRUE(contains(scan(R"("scenes": [{"nodes": [1]}], )").surface_only, R"("scene":0)"));
    const Prescan none = scan("");
    EXPECT_EQ(none.unread.nodes_of_no_scene, 2u);
    EXPECT_EQ(none.unread.nodes, 0u);
    EXPECT_TRUE(contains(none.surface_only, R"("scenes":[{"nodes":[0,1]}])")) << none.surface_only;
    const Prescan library = prescan_gltf(gltf(R"("meshes": [{"primitives": []}, {"primitives": []}])"));
    EXPECT_EQ(library.unread.nodes_of_no_scene, 2u);
    EXPECT_TRUE(contains(library.surface_only, R"("nodes":[{"mesh":0},{"mesh":1}])")) << library.surface_only;
}

TEST(PrescanGltf, RefusesScenesOfNodesThatAreNotThere) {
    EXPECT_TRUE(contains(gltf_message(gltf(R"("scene": 1, "scenes": [{}])")), "scene 1 is not there"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("scene": 1)")), "scene 1 is not there"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("scene": -1, "scenes": [{}])")), "scene is not a size"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("scenes": [{"nodes": [0]}])")), "scene 0 has a node that is not there"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("scenes": [{"nodes": [0, 0]}], "nodes": [{}])")), "node 0 twice"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("scenes": [7])")), "scenes is not an object"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("nodes": [{"mesh": 0}])")), "node 0 has a mesh that is not there"));
}

TEST(PrescanGltf, AVisualMeshMayBePaintedInAnyWay) {
    const std::string text = gltf(R"("buffers": [{"byteLength": 36, "uri": "a.bin"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3},
                      {"componentType": 5121, "type": "VEC4", "count": 2}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}}]}])");
    EXPECT_NE(gltf_message(text), "");
    EXPECT_FALSE(contains(prescan_gltf(text, Purpose::visual).surface_only, "COLOR_0"));
}

TEST(PrescanGltf, RefusesNodesAboveThemselvesAndJsonWithoutBottom) {
    EXPECT_EQ(gltf_message(gltf(R"("nodes": [{"children": [1]}, {}])")), "");
    EXPECT_TRUE(contains(gltf_message(gltf(R"("nodes": [{"children": [1]}, {"children": [0]}])")), "within itself"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("nodes": [{"children": [2]}, {"children": [2]}, {}])")), "two parents"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("nodes": [{"children": [7]}])")), "not there"));
    EXPECT_TRUE(contains(gltf_message(gltf("\"extras\": " + std::string(100000, '['))), "nested"));
    std::string chain = R"("nodes": [)";
    for (int i = 1; i < 3000; ++i) chain += R"({"children": [)" + std::to_string(i) + "]}, ";
    EXPECT_TRUE(contains(gltf_message(gltf(chain + "{}]")), "more than 1000 deep"));
}

TEST(PrescanGltf, HandsOnSurfaceAndPaintOnly) {
    const Prescan scan = prescan_gltf(gltf(R"("scene": 0, "scenes": [{"nodes": [0], "extras": {}}],
        "nodes": [{"mesh": 0, "skin": 0, "camera": 0, "name": "body"}], "skins": [{"joints": [0]}], "animations": [{}],
        "materials": [{"name": "steel", "pbrMetallicRoughness": {"baseColorTexture": {"index": 9}}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 0, "JOINTS_0": 0}, "targets": [{}]}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 1, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri": "my%20a.bin"}, {"byteLength": 36, "uri": "walk.bin"}])"));
    ASSERT_EQ(scan.buffers.size(), 1u);  // the other one holds no surface
    EXPECT_EQ(scan.buffers[0].uri, "my%20a.bin");
    EXPECT_EQ(scan.buffers[0].size, 36u);
    EXPECT_TRUE(contains(scan.surface_only, scan.buffers[0].name));
    for (const char* kept : {"POSITION", "steel", "body"}) EXPECT_TRUE(contains(scan.surface_only, kept)) << kept;
    for (const char* gone :
         {"skin", "camera", "animations", "Texture", "NORMAL", "JOINTS", "targets", "extras", "my%20"})
        EXPECT_FALSE(contains(scan.surface_only, gone)) << gone;
}

TEST(PrescanGltf, RefusesBuffersShorterThanAnnounced) {
    EXPECT_TRUE(contains(gltf_message(gltf(R"("buffers": [{"byteLength": 36}])")), "buffer 0 has no uri"));
    EXPECT_EQ(gltf_message(gltf(R"("buffers": [{"byteLength": 0}])")), "");
}

TEST(PrescanGltf, RefusesBinaryFilesWithLyingSizes) {
    const std::string json = R"({"asset": {"version": "2.0"}}   )";
    const auto u32 = [](std::uint32_t value) {
        std::string bytes(4, '\0');
        std::memcpy(bytes.data(), &value, 4);
        return bytes;
    };
    const auto size = static_cast<std::uint32_t>(json.size());
    const std::string good = "glTF" + u32(2) + u32(20 + size) + u32(size) + "JSON" + json;
    EXPECT_EQ(gltf_message(good), "");
    for (std::size_t cut = 4; cut < good.size(); ++cut) EXPECT_NE(gltf_message(good.substr(0, cut)), "") << cut;
    EXPECT_TRUE(contains(gltf_message("glTF" + u32(1) + u32(20 + size) + u32(size) + "JSON" + json), "version 1"));
    EXPECT_TRUE(contains(gltf_message("glTF" + u32(2) + u32(20 + size) + u32(0xfffffff0u) + "JSON" + json),
                         "longer than the file"));
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
