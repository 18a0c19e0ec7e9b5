// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/scene.h"

#include <cmath>
#include <limits>

#include "importer/import_checks.h"

namespace crumple::importer {
namespace {

Scene small_scene() {
    Scene scene;
    scene.generator = "writer";
    scene.unit = 0.01;
    scene.up = Up::z;
    scene.axes = axes_of(Up::z);
    scene.expected_triangles = 2;
    SceneMesh mesh;
    mesh.name = "body";
    mesh.material = "paint";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.colors = {{}, std::vector<Color>(4, Color{0, 1, 1, 1})};
    mesh.points_and_lines = 3;
    mesh.unreadable_polygons = 1;
    scene.meshes = {mesh};
    scene.nodes = {SceneNode{"root", none, SceneNode{}.transform, {}},
                   SceneNode{"car", 0, SceneNode{}.transform, {0, 0}}};
    return scene;
}

std::string message_of(const std::vector<std::byte>& bytes) {
    return test::refusal_of([&] { (void)decode(bytes); }).message;
}

TEST(Scene, ComesBackAsItWas) {
    const Scene scene = small_scene();
    const Scene back = decode(encode(scene));
    EXPECT_EQ(back.generator, scene.generator);
    EXPECT_EQ(back.unit, scene.unit);
    EXPECT_EQ(back.up, scene.up);
    EXPECT_EQ(back.axes, scene.axes);
    EXPECT_EQ(back.expected_triangles, 2u);
    ASSERT_EQ(back.meshes.size(), 1u);
    EXPECT_EQ(back.meshes[0].name, "body");
    EXPECT_EQ(back.meshes[0].material, "paint");
    EXPECT_EQ(back.meshes[0].positions, scene.meshes[0].positions);
    EXPECT_EQ(back.meshes[0].triangles, scene.meshes[0].triangles);
    EXPECT_EQ(back.meshes[0].colors, scene.meshes[0].colors);
    EXPECT_EQ(back.meshes[0].points_and_lines, 3u);
    ASSERT_EQ(back.nodes.size(), 2u);
    EXPECT_EQ(back.nodes[1].parent, 0u);
    EXPECT_EQ(back.nodes[1].meshes, (std::vector<Index>{0, 0}));
    EXPECT_EQ(encode(back), encode(scene));
}

TEST(Scene, EveryTruncationIsRefused) {
    auto bytes = encode(small_scene());
    while (!bytes.empty()) {
        bytes.pop_back();
        EXPECT_NE(message_of(bytes), "") << bytes.size();
    }
}

TEST(Scene, TrailingBytesAreRefused) {
    auto bytes = encode(small_scene());
    bytes.push_back(std::byte{0});
    EXPECT_TRUE(test::contains(message_of(bytes), "left over"));
}

// Whatever a byte becomes, decode answers or refuses; it never takes memory a lying count asks for.
TEST(Scene, EveryFlippedByteIsReadOrRefused) {
    const auto good = encode(small_scene());
    for (std::size_t i = 0; i < good.size(); ++i) {
        for (const unsigned flip : {0x01u, 0x80u, 0xffu}) {
            auto bytes = good;
            bytes[i] ^= static_cast<std::byte>(flip);
            (void)message_of(bytes);
        }
    }
}

template <class Change>
std::string message_after(Change&& change) {
    Scene scene = small_scene();
    change(scene);
    return message_of(encode(scene));
}

TEST(Scene, LiesAreRefused) {
    EXPECT_EQ(message_after([](Scene&) {}), "");
    EXPECT_NE(message_after([](Scene& s) { s.meshes[0].triangles[0][1] = 4; }), "");
    EXPECT_NE(message_after([](Scene& s) { s.meshes[0].colors[1].pop_back(); }), "");
    EXPECT_NE(message_after([](Scene& s) { s.meshes[0].colors.resize(9); }), "");
    EXPECT_NE(message_after([](Scene& s) { s.meshes[0].file_vertex = {0, 0, 0, 0}; }), "");
    EXPECT_NE(message_after([](Scene& s) { s.file_positions = {{0, 0, 0}}; }), "");
    EXPECT_NE(message_after([](Scene& s) {
                  s.file_positions = {{0, 0, 0}};
                  s.meshes[0].file_vertex = {0, 0, 0, 1};
              }),
              "");
    EXPECT_NE(message_after([](Scene& s) { s.nodes[1].parent = 1; }), "");
    EXPECT_NE(message_after([](Scene& s) { s.nodes[1].meshes[0] = 1; }), "");
    EXPECT_NE(message_after([](Scene& s) { s.nodes[1].transform[3] = std::numeric_limits<double>::infinity(); }), "");
    EXPECT_NE(message_after([](Scene& s) { s.unit = -1; }), "");
    EXPECT_NE(message_after([](Scene& s) { s.unit = std::nan(""); }), "");
    EXPECT_NE(message_after([](Scene& s) { s.up = static_cast<Up>(-1); }), "");
}

TEST(Scene, NonFinitePositionIsNamed) {
    const std::string message = message_after([](Scene& s) { s.meshes[0].positions[2].y = std::nanf(""); });
    EXPECT_TRUE(test::contains(message, "vertex 2 of mesh 'body'")) << message;
}

TEST(Scene, NamesAreMadePrintable) {
    Scene scene = small_scene();
    scene.nodes[1].name = "a\nb\xff\xc3\xa4";
    EXPECT_EQ(decode(encode(scene)).nodes[1].name, "a?b?\xc3\xa4");
}

}
}
