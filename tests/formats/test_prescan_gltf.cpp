// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/prescan.h"

#include <cstring>
#include <string>

#include "importer/import_checks.h"

namespace crumple::formats {
namespace {

using test::bad_input_of;
using test::contains;

std::string gltf_message(const std::string& text) {
    return bad_input_of([&] { (void)prescan_gltf(text); });
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
    const std::string color = R"({"bufferView": 0, "componentType": 5121, "type": "VEC4", "count": )";
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

TEST(PrescanGltf, RefusesPaintThatAssimpWouldLeaveOut) {
    const auto message = [](const std::string& name, int type, const std::string& shape) {
        return gltf_message(gltf(R"("buffers": [{"byteLength": 48, "uri": "a.bin"}],
            "bufferViews": [{"buffer": 0, "byteLength": 48}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3},
                          {"bufferView": 0, "componentType": )" +
                                 std::to_string(type) + R"(, "type": ")" + shape + R"(", "count": 3}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, ")" +
                                 name + R"(": 1}}]}])"));
    };
    for (const int type : {5121, 5123, 5126}) EXPECT_EQ(message("COLOR_0", type, "VEC4"), "") << type;
    EXPECT_EQ(message("COLOR_1", 5126, "VEC3"), "");
    for (const int type : {5120, 5122, 5125}) EXPECT_TRUE(contains(message("COLOR_0", type, "VEC4"), "COLOR_0 is not"));
    EXPECT_TRUE(contains(message("COLOR_0", 5126, "VEC2"), "COLOR_0 is not"));
    for (const char* name : {"color_0", "COLOR", "_COLOR_0", "_Color"})
        EXPECT_TRUE(contains(message(name, 5126, "VEC4"), "looks like a colour")) << name;
    for (const char* name : {"NORMAL", "_temperature", "JOINTS_0"}) EXPECT_EQ(message(name, 5126, "VEC4"), "") << name;
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

// The accessors' elements of 4 and 12 bytes, so many bytes apart.
std::string with_stride(int stride) {
    return gltf(R"("buffers": [{"byteLength": 36, "uri": "a.bin"}, {"byteLength": 12, "uri": "b.bin"}],
                   "bufferViews": [{"buffer": 0, "byteLength": 36},
                                   {"buffer": 1, "byteLength": 12, "byteStride": )" +
                std::to_string(stride) + R"(}],
                   "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3},
                                 {"bufferView": 1, "componentType": 5121, "type": "VEC4", "count": 3}],
                   "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}}]}])");
}

TEST(PrescanGltf, ElementsThatOverlapAreRefused) {
    EXPECT_EQ(gltf_message(with_stride(4)), "");
    EXPECT_EQ(gltf_message(with_stride(0)), "");
    EXPECT_TRUE(
        contains(gltf_message(with_stride(3)), "accessor 1 has elements of 4 bytes, which its buffer view puts 3"));
    std::string none_at_all = with_stride(4);
    const std::string view = R"("bufferView": 1, )";
    none_at_all.erase(none_at_all.find(view), view.size());
    EXPECT_TRUE(contains(gltf_message(none_at_all), "COLOR_0 has no buffer view"));
}

TEST(PrescanGltf, TransformsAreAffineAndFinite) {
    const auto matrix = [](const std::string& end) {
        return gltf_message(gltf(R"("nodes": [{"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, )" + end + "]}]"));
    };
    EXPECT_EQ(matrix("0, 1"), "");
    EXPECT_TRUE(contains(matrix("0, 0"), "not affine"));
    EXPECT_TRUE(contains(matrix("1e300, 1"), "beyond the range of a float"));
    EXPECT_TRUE(contains(gltf_message(gltf(R"("nodes": [{"scale": [1, 1, 1e39]}])")), "a node's scale is beyond"));
    EXPECT_EQ(gltf_message(gltf(R"("nodes": [{"rotation": [0, 0, 0.7071068, 0.7071068]}])")), "");
    EXPECT_TRUE(contains(gltf_message(gltf(R"("nodes": [{"rotation": [0, 0, 1, 1]}])")), "no unit quaternion"));
}

TEST(PrescanGltf, WhatMovesTheSurfaceBesidesItsNodesIsCounted) {
    const std::string mesh = R"("meshes": [{"primitives": [], "weights": [0, 1]}], )";
    const Prescan scan =
        prescan_gltf(gltf(mesh + R"("nodes": [{"mesh": 0, "skin": 0}, {"mesh": 0, "weights": [0]}, {"skin": 0}])"));
    EXPECT_EQ(scan.unread.skins, 1u);
    EXPECT_EQ(scan.unread.morphs, 1u);
}

TEST(PrescanGltf, CornersThatAreNoWholeTriangleAreRefused) {
    const auto file = [](int corners) {
        return gltf(R"("accessors": [{"componentType": 5126, "type": "VEC3", "count": )" + std::to_string(corners) +
                    R"(, "bufferView": 0}], "buffers": [{"byteLength": 84, "uri": "a.bin"}],
                       "bufferViews": [{"buffer": 0, "byteLength": 84}],
                       "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}])");
    };
    EXPECT_EQ(prescan_gltf(file(6)).expected_triangles, 2u);
    EXPECT_TRUE(contains(gltf_message(file(7)), "has 7 corners, which are no whole triangles"));
}

TEST(PrescanGltf, TheLengthOfABinaryFileIsWhatItsHeaderSays) {
    const std::string json = R"({"asset": {"version": "2.0"}}   )";
    const auto u32 = [](std::size_t value) {
        const auto number = static_cast<std::uint32_t>(value);
        return std::string(reinterpret_cast<const char*>(&number), sizeof number);
    };
    const auto file = [&](std::size_t length) {
        return "glTF" + u32(2) + u32(length) + u32(json.size()) + "JSON" + json + "more";
    };
    const std::size_t whole = 20 + json.size();
    EXPECT_EQ(prescan_gltf(file(whole)).unread.bytes, 4u);
    EXPECT_EQ(prescan_gltf(file(whole + 4)).unread.bytes, 0u);
    EXPECT_TRUE(contains(gltf_message(file(whole - 4)), "JSON chunk is longer than the file, or than its header"));
    EXPECT_TRUE(contains(gltf_message(file(12)), "the header announces 12 bytes"));
    EXPECT_TRUE(contains(gltf_message(file(whole + 5)), "the header announces"));
}

}
}
