// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/prescan.h"

#include <cstring>

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

TEST(PrescanObj, AVisualMeshMayMixThreeAndSix) {
    EXPECT_EQ(obj_message("v 0 0 0\nv 1 0 0 0 0 0\nf 1 2 1\n", Purpose::visual), "");
    EXPECT_TRUE(contains(obj_message("v 0 0 0 1\n", Purpose::visual), "line 1"));
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
    for (const std::string type : {"char", "int8", "short", "int16", "int", "int32"}) {
        const std::string file = ply("element vertex 1\n" + xyz + "property " + type + " red\n", "0 0 0 0\n");
        EXPECT_TRUE(contains(ply_message(file), "'red' is of a signed type")) << type;
        EXPECT_EQ(ply_message(file, Purpose::visual), "") << type;
    }
    for (const std::string type : {"uchar", "ushort", "uint", "float", "double"})
        EXPECT_EQ(ply_message(ply("element vertex 1\n" + xyz + "property " + type + " red\n", "0 0 0 0\n")), "")
            << type;
}

TEST(PrescanPly, RefusesPaintUnderAnotherName) {
    const auto named = [](const std::string& name) {
        return ply("element vertex 1\n" + xyz + "property uchar " + name + "\n", "0 0 0 0\n");
    };
    for (const std::string name : {"Red", "RED", "R", "diffuse_red", "vertex_color", "rgb", "red_"}) {
        EXPECT_TRUE(contains(ply_message(named(name)), "'" + name + "' looks like a colour")) << name;
        EXPECT_EQ(ply_message(named(name), Purpose::visual), "") << name;
    }
    for (const std::string name : {"red", "r", "intensity", "reduced", "radius"})
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
    EXPECT_EQ(message_of([&] { (void)prescan_off(file("OFF", " 255 0 0"), Purpose::visual); }), "");
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
