// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/prescan.h"

#include <cmath>
#include <limits>
#include <string>

#include "importer/import_checks.h"

namespace crumple::formats {
namespace {

using test::bad_input_of;
using test::contains;

std::string ply_message(const std::string& bytes, Purpose purpose = Purpose::shell) {
    return bad_input_of([&] { (void)prescan_ply(bytes, purpose); });
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

TEST(PrescanPly, RefusesPaintWithoutRed) {
    for (const std::string name : {"green", "blue", "b"}) {
        const std::string file = ply("element vertex 1\n" + xyz + "property uchar " + name + "\n", "0 0 0 0\n");
        EXPECT_TRUE(contains(ply_message(file), "line 8: the header gives a vertex '" + name + "' but no red")) << name;
        EXPECT_EQ(ply_message(file, Purpose::visual), "") << name;
    }
    EXPECT_EQ(ply_message(ply("element vertex 1\n" + xyz + "property uchar alpha\n", "0 0 0 0\n")), "");
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
    EXPECT_TRUE(contains(ply_message("ply\rformat binary_little_endian 1.0\rend_header\r\n\1\n"), "line feeds"));
    EXPECT_FALSE(contains(ply_message("ply\r\r\nformat ascii 1.0\r\r\n"), "line feeds"));
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
    EXPECT_TRUE(contains(ply_message(ply("element vertex 1\n" + xyz + "element face 1\n" + faces +
                                             "property list uchar int vertex_index\n",
                                         "0 0 0\n3 0 0 0 3 0 0 0\n")),
                         "more than one list"));
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

TEST(PrescanPly, RefusesListsOfNegativeLength) {
    const std::string header = "element vertex 1\n" + xyz + "element face 1\nproperty list char int ";
    EXPECT_TRUE(contains(ply_message(ply(header + "vertex_indices\n", "0 0 0\n-1\n")), "face 0 has a list"));
    EXPECT_TRUE(contains(ply_message(ply(header + "flags\n" + faces, "0 0 0\n-1 3 0 0 0\n")), "'flags'"));
    const std::string binary = ply(header + "vertex_indices\n", std::string(12, '\0') + "\xff", "binary_big_endian");
    EXPECT_TRUE(contains(ply_message(binary), "face 0 has a list"));
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

}
}
