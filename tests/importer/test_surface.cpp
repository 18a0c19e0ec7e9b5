// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/surface.h"

#include <limits>

#include "importer/import_checks.h"
#include "importer/visual.h"

namespace crumple::importer {
namespace {

constexpr formats::Affine identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

Scene scene_with(const formats::Affine& transform) {
    Scene scene;
    SceneMesh mesh;
    mesh.name = "mesh";
    mesh.positions = {{1, 2, 3}, {2, 2, 3}, {1, 3, 3}};
    mesh.triangles = {{0, 1, 2}};
    scene.meshes = {mesh};
    scene.nodes = {SceneNode{"node", none, transform, {0}}};
    return scene;
}

Surface flatten_with(const Scene& scene, const Params& params = {}) {
    return flatten(scene, placement_of(scene, params), params, "file");
}

Vec3 first_position(const Scene& scene, const Params& params = {}) {
    return flatten_with(scene, params).positions.at(0);
}

TEST(Surface, SceneWithoutNodesIsEmpty) { EXPECT_TRUE(flatten_with(Scene{}).positions.empty()); }

TEST(Surface, NodesComposeFromTheRoot) {
    Scene scene = scene_with({1, 0, 0, 10, 0, 1, 0, 0, 0, 0, 1, 0});
    scene.nodes.insert(scene.nodes.begin(), SceneNode{"root", none, {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 5}, {}});
    scene.nodes[1].parent = 0;
    EXPECT_EQ(first_position(scene), (Vec3{22, 4, 11}));
}

TEST(Surface, MirroredNodeTurnsTriangles) {
    EXPECT_EQ(flatten_with(scene_with(identity)).triangles[0], (Triangle{0, 1, 2}));
    EXPECT_EQ(flatten_with(scene_with({-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0})).triangles[0], (Triangle{0, 2, 1}));
    EXPECT_EQ(flatten_with(scene_with({-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0})).triangles[0], (Triangle{0, 1, 2}));
}

TEST(Surface, MirroringAxesTurnTriangles) {
    Scene scene = scene_with(identity);
    scene.axes = {0, 1, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_EQ(first_position(scene), (Vec3{2, 1, 3}));
    EXPECT_EQ(flatten_with(scene).triangles[0], (Triangle{0, 2, 1}));
}

TEST(Surface, UnitAndUpComeFromTheFileUnlessParamsSay) {
    Scene scene = scene_with(identity);
    EXPECT_EQ(first_position(scene), (Vec3{1, 2, 3}));
    scene.unit = 0.5;
    scene.up = Up::z;
    scene.axes = axes_of(Up::z);
    EXPECT_EQ(first_position(scene), (Vec3{0.5, 1.5, -1}));
    Params params;
    params.unit = 2;
    EXPECT_EQ(first_position(scene, params), (Vec3{2, 6, -4}));
    params.up = Up::y;
    EXPECT_EQ(first_position(scene, params), (Vec3{2, 4, 6}));
    params.up = Up::x;
    EXPECT_EQ(first_position(scene, params), (Vec3{-4, 2, 6}));
}

TEST(Surface, ProductsAreRoundedOnce) {
    Scene scene = scene_with({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
    scene.meshes[0].positions[0] = {0.1f, 1.1f, -0.0f};
    scene.unit = 0.01;
    const Vec3 p = first_position(scene);
    EXPECT_EQ(p.x, static_cast<float>(static_cast<double>(0.1f) * 0.01));
    EXPECT_EQ(p.y, static_cast<float>(static_cast<double>(1.1f) * 0.01));
    EXPECT_FALSE(std::signbit(p.z));
}

TEST(Surface, InstancesKeepTheirSourceVertices) {
    Scene scene = scene_with(identity);
    scene.nodes.push_back(SceneNode{"second", none, {1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0}, {0}});
    const Surface surface = flatten_with(scene);
    EXPECT_EQ(surface.source_vertex, (std::vector<Index>{0, 1, 2, 0, 1, 2}));
    EXPECT_EQ(surface.objects.size(), 2u);
    EXPECT_EQ(surface.source_vertex_count, 3u);
}

TEST(Surface, ObjectsAreNamedByNodeMeshOrFile) {
    Scene scene = scene_with(identity);
    EXPECT_EQ(flatten_with(scene).objects[0].name, "node");
    scene.nodes[0].name = "";
    EXPECT_EQ(flatten_with(scene).objects[0].name, "mesh");
    scene.meshes[0].name = "meshes[0]-1";
    EXPECT_EQ(flatten_with(scene).objects[0].name, "file");
}

TEST(Surface, WhatLeavesFloatIsRefused) {
    Scene scene = scene_with(identity);
    scene.unit = std::numeric_limits<double>::max();
    EXPECT_EQ(test::refusal_of([&] { (void)flatten_with(scene); }).kind, ErrorKind::bad_input);
    scene.unit = 3e38;
    EXPECT_EQ(test::refusal_of([&] { (void)flatten_with(scene); }).kind, ErrorKind::bad_input);
}

// A few kilobytes can name a mesh a billion times.
TEST(Surface, MultiplyingInstancesAreRefusedBeforeMemoryIsTaken) {
    Scene scene = scene_with(identity);
    scene.meshes[0].positions.resize(100'000);
    for (int i = 0; i < 2000; ++i)
        scene.nodes.push_back(SceneNode{"more", none, identity, std::vector<Index>(1000, 0)});
    const auto refusal = test::refusal_of([&] { (void)flatten_with(scene); });
    EXPECT_TRUE(test::contains(refusal.message, "import.memory_mb")) << refusal.message;
}

TEST(Visual, WithoutAVertexListKeepsEveryVertex) {
    const VisualMesh mesh = make_visual("m", flatten_with(scene_with(identity)), {});
    EXPECT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(mesh.source_vertex, (std::vector<Index>{0, 1, 2}));
}

TEST(Visual, WithAVertexListIsThatList) {
    Scene scene = scene_with(identity);
    scene.file_positions = {{9, 9, 9}, {1, 3, 3}, {2, 2, 3}, {1, 2, 3}};
    scene.meshes[0].file_vertex = {3, 2, 1};
    const Surface surface = flatten_with(scene);
    EXPECT_TRUE(surface.has_vertex_list);
    EXPECT_EQ(surface.source_vertex_count, 4u);
    const VisualMesh mesh = make_visual("m", surface, place_vertex_list(scene, placement_of(scene, {})));
    EXPECT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.positions[0], (Vec3{9, 9, 9}));
    EXPECT_EQ(mesh.triangles[0], (Triangle{3, 2, 1}));
}

}
}
