// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/read_scene.h"

#include <string>

#include "importer/import_checks.h"
#include "importer/input_files.h"
#include "importer/obj_text.h"
#include "importer/temp_folder.h"
#include "mesh/shapes.h"

namespace crumple::importer {
namespace {

using test::contains;
using test::find;
using test::has;
using test::import_shell;
using test::obj_text;
using test::refusal_of_file;
using test::TempFolder;

TEST(ReadScene, EmptyAndForeignContentIsRefusedInEveryFormat) {
    const TempFolder folder;
    for (const char* extension : {"obj", "ply", "off", "stl", "gltf", "glb", "dae", "fbx", "x"}) {
        for (const std::string& content :
             {std::string(), std::string("hello"), std::string(1000, '\0'), std::string(300, '\xff')}) {
            const auto refusal = refusal_of_file(folder.write(std::string("a.") + extension, content));
            EXPECT_EQ(refusal.kind, ErrorKind::bad_input) << extension << " of " << content.size() << " bytes";
            EXPECT_FALSE(refusal.message.empty());
        }
    }
}

TEST(ReadScene, WhatEditorsAndVersionControlMakeOfAFile) {
    const TempFolder folder;
    const std::string box = obj_text(shapes::box());
    EXPECT_EQ(import_shell(folder.write("mark.obj", "\xef\xbb\xbf" + box)).report.vertices, 8u);
    std::string windows = box;
    for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2) windows.insert(at, 1, '\r');
    EXPECT_EQ(import_shell(folder.write("windows.obj", windows)).report.vertices, 8u);
    std::string mac = box;
    std::replace(mac.begin(), mac.end(), '\n', '\r');
    EXPECT_TRUE(contains(refusal_of_file(folder.write("mac.obj", mac)).message, "carriage returns"));
    EXPECT_TRUE(contains(refusal_of_file(folder.write("wide.obj", "\xff\xfev\0")).message, "UTF-16"));
    for (const char* name : {"a.obj", "a.glb", "a.fbx", "a.stl"}) {
        const std::string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 12\n";
        EXPECT_TRUE(contains(refusal_of_file(folder.write(name, pointer)).message, "git lfs pull")) << name;
    }
}

// A box as PLY in text, each vertex of that colour.
std::string ply_text(const std::string& color, const std::string& after_vertex) {
    std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face 12\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vec3& p : shapes::box().positions)
        ply += std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + color + after_vertex;
    if (!ply.ends_with('\n')) ply += '\n';
    for (const Triangle& t : shapes::box().triangles)
        ply += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
    return ply;
}

TEST(ReadScene, WhatIsNotReadIsTold) {
    const TempFolder folder;
    const Result curves =
        import_shell(folder.write("a.obj", obj_text(shapes::box()) + "curv 0 1 1 2 3\nsurf 0 1 0 1 1\n"));
    EXPECT_EQ(find(curves.report.findings, "FILE_FREE_FORM")->count, 2u);
    const std::string ply = ply_text(" 0 255 255", "\n");
    EXPECT_FALSE(has(import_shell(folder.write("a.ply", ply + "\n")).report, "FILE_UNREAD"));
    EXPECT_EQ(find(import_shell(folder.write("a.ply", ply + "3 0 1 2\n")).report.findings, "FILE_UNREAD")->count, 8u);
}

// assimp reads a line where we read numbers, takes "+255" for 0, and loses its place at elements before the vertices.
TEST(ReadScene, APlyIsReadAsItsHeaderSays) {
    const TempFolder folder;
    EXPECT_EQ(import_shell(folder.write("a.ply", ply_text(" 0 255 255", "\n"))).report.locked, 8u);
    EXPECT_EQ(import_shell(folder.write("a.ply", ply_text(" 255 255 255", "\n\n"))).report.locked, 0u);
    EXPECT_EQ(import_shell(folder.write("joined.ply", ply_text(" 255 255 255", " "))).report.locked, 0u);
    EXPECT_EQ(import_shell(folder.write("plus.ply", ply_text(" +255 255 255", "\n"))).report.locked, 0u);
    std::string camera = ply_text(" 0 255 255", "\n");
    camera.insert(camera.find("element vertex"), "element camera 1\nproperty float view_px\nproperty int flag\n");
    camera.insert(camera.find("end_header\n") + 11, "0.5 2\n");
    const Result seen = import_shell(folder.write("camera.ply", camera));
    EXPECT_EQ(seen.report.locked, 8u);
    EXPECT_EQ(seen.asset.shell.positions, shapes::box().positions);
    EXPECT_EQ(seen.asset.shell.triangles, shapes::box().triangles);
}

TEST(ReadScene, FacesOfAPlyMayHaveAnyNumberOfCorners) {
    const TempFolder folder;
    std::string ply = ply_text(" 0 255 255", "\n");
    ply.replace(ply.find("face 12"), 7, "face 15");
    const Result result = import_shell(folder.write("a.ply", ply + "0\n1 3\n2 0 1\n"));
    EXPECT_EQ(result.report.triangles, 12u);
    EXPECT_EQ(result.report.shell.points_and_lines, 2u);
}

TEST(ReadScene, AFileWithoutFacesIsRefusedByALookAtItsBytesToo) {
    const TempFolder folder;
    const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
    for (const auto& [name, text] :
         {std::pair<std::string, std::string>{
              "a.ply", "ply\nformat ascii 1.0\nelement vertex 1\n" + xyz + "end_header\n0 0 0\n"},
          {"a.off", "OFF\n1 0 0\n0 0 0\n"},
          {"a.gltf", R"({"asset": {"version": "2.0"}})"}}) {
        Sources sources;
        sources.shell = folder.write(name, text);
        EXPECT_TRUE(contains(refusal_of_file(sources.shell).message, "no faces")) << name;
        EXPECT_TRUE(contains(test::refusal_of([&] { look_at_inputs(sources); }).message, "no faces")) << name;
    }
}

TEST(ReadScene, PaintThatIsNoVertexsIsToldWhereNoVertexHasAny) {
    const TempFolder folder;
    const std::string box = obj_text(shapes::box());
    EXPECT_EQ(
        find(import_shell(folder.write("a.obj", box + "#MRGB ff00000000ff00ff\n")).report.findings, "COLOR_IN_COMMENTS")
            ->count,
        2u);
    std::string off = "OFF\n8 12 0\n";
    for (const Vec3& p : shapes::box().positions)
        off += std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    for (const Triangle& t : shapes::box().triangles)
        off += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + " 255 0 0\n";
    const Result faces = import_shell(folder.write("a.off", off));
    EXPECT_EQ(find(faces.report.findings, "COLOR_ON_FACES")->count, 12u);
    EXPECT_EQ(faces.report.locked, 0u);
    const std::string painted = obj_text(shapes::box(), [](std::size_t) { return 1; });
    EXPECT_FALSE(has(import_shell(folder.write("b.obj", painted + "#MRGB ff000000\n")).report, "COLOR_IN_COMMENTS"));
}

// A box as glTF in text.
std::string gltf_text(const std::string& rest) {
    return R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 168, "uri": "box.bin"}],
        "bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 8},
                      {"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 36}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}])" +
           rest + "}";
}

std::string gltf_buffer() {
    std::string bytes;
    const auto append = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    for (const Vec3& p : shapes::box().positions) append(narrow(p));
    for (const Triangle& t : shapes::box().triangles) {
        for (const Index v : t) append(static_cast<std::uint16_t>(v));
    }
    return bytes;
}

TEST(ReadScene, AGltfWithoutScenesIsALibraryOfWhatItHolds) {
    const TempFolder folder;
    (void)folder.write("box.bin", gltf_buffer());
    const Result library = import_shell(folder.write("a.gltf", gltf_text("")));
    EXPECT_EQ(library.asset.shell.positions, shapes::box().positions);
    EXPECT_EQ(find(library.report.findings, "FILE_NO_SCENE")->count, 1u);
    const std::string nodes = R"(, "nodes": [{"mesh": 0, "name": "box"}, {"mesh": 0, "translation": [5, 0, 0]}])";
    EXPECT_EQ(import_shell(folder.write("b.gltf", gltf_text(nodes))).report.components.size(), 2u);
    const Result one = import_shell(folder.write("c.gltf", gltf_text(nodes + R"(, "scenes": [{"nodes": [0]}])")));
    EXPECT_EQ(one.report.components.at(0).name, "box");
    EXPECT_EQ(find(one.report.findings, "FILE_NODES_UNREAD")->count, 1u);
    EXPECT_FALSE(has(one.report, "FILE_NO_SCENE"));
}

TEST(ReadScene, AMeshOfAGltfThatNoSceneHoldsIsNotMissed) {
    const TempFolder folder;
    (void)folder.write("box.bin", gltf_buffer());
    std::string json = gltf_text(R"(, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}, {"mesh": 1}])");
    const std::string mesh = R"({"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]})";
    json.replace(json.find(mesh), mesh.size(), mesh + ", " + mesh + ", " + mesh);
    const Result result = import_shell(folder.write("a.gltf", json));
    EXPECT_EQ(result.asset.shell.triangles.size(), 12u);
    EXPECT_FALSE(has(result.report, "FILE_FACES_LOST"));
}

TEST(ReadScene, ATriangleOfAGltfThatRefersToNoVertexIsRefused) {
    const TempFolder folder;
    std::string bytes = gltf_buffer();
    bytes[bytes.size() - 2] = 8;
    (void)folder.write("box.bin", bytes);
    const auto refusal = refusal_of_file(folder.write("a.gltf", gltf_text("")));
    EXPECT_EQ(refusal.kind, ErrorKind::bad_input);
    EXPECT_TRUE(contains(refusal.message, "1 of its 12 triangles refer to vertices that are not there"))
        << refusal.message;
    constexpr std::size_t first_index = 96;
    for (std::size_t high_byte = first_index + 1; high_byte < bytes.size(); high_byte += 2) bytes[high_byte] = 1;
    (void)folder.write("box.bin", bytes);
    const auto all = refusal_of_file(folder.write("a.gltf", gltf_text("")));
    EXPECT_TRUE(contains(all.message, "12 of its 12 triangles refer to vertices that are not there")) << all.message;
}

TEST(ReadScene, AGltfIsWhatItsBytesAreWhateverItIsCalled) {
    const TempFolder folder;
    const std::string scene =
        R"(, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}], "extensionsRequired": ["MSFT_lod"])";
    (void)folder.write("box.bin", gltf_buffer());
    const Result text = import_shell(folder.write("text.glb", gltf_text(scene)));
    EXPECT_EQ(text.report.vertices, 8u);
    EXPECT_TRUE(contains(find(text.report.findings, "FILE_EXTENSION")->message, "MSFT_lod"));
    std::string json = gltf_text(scene);
    json.append((4 - json.size() % 4) % 4, ' ');
    std::string binary = "glTF";
    for (const std::size_t word : {std::size_t{2}, 20 + json.size(), json.size()}) {
        const auto u32 = static_cast<std::uint32_t>(word);
        binary.append(reinterpret_cast<const char*>(&u32), sizeof u32);
    }
    EXPECT_EQ(import_shell(folder.write("binary.gltf", binary + "JSON" + json)).report.vertices, 8u);
}

TEST(ReadScene, OddPaintOfAVisualMeshDoesNotMatter) {
    const TempFolder folder;
    Sources sources;
    sources.shell = folder.write("shell.obj", obj_text(shapes::box()));
    const std::string rgba = "v 0 0 0 1 1 1 1\nv 1 0 0 1 1 1 1\nv 0 1 0 1 -1.#IND 1\nf 1 2 3\n";
    std::string ply = ply_text(" -3 255 255", "\n");
    for (const auto& [name, text] : {std::pair<std::string, std::string>{"a.obj", rgba},
                                     {"a.ply", ply},
                                     {"a.off", "CNOFF\n3 1 0\n0 0 0 1 x\n1 0 0\n0 1 0 255 0 0\n3 0 1 2 7\n"}}) {
        sources.visuals = {{"", folder.write(name, text)}};
        const Result result = import_asset(sources);
        EXPECT_EQ(result.asset.visuals.at(0).triangles.size(), name == "a.ply" ? 12u : 1u) << name;
    }
    EXPECT_EQ(refusal_of_file(folder.write("shell.ply", ply)).kind, ErrorKind::bad_input);
}

TEST(ReadScene, MaterialsKeepTheirNamesThoughTheirLibraryIsNotRead) {
    const TempFolder folder;
    (void)folder.write("a.mtl", "newmtl steel\nnewmtl other\n");
    const std::string path = folder.write("a.obj", "mtllib a.mtl\nusemtl steel\n" + obj_text(shapes::box()));
    EXPECT_EQ(import_shell(path).report.components.at(0).material, "steel");
}

// Black facets and a black default colour, as some programs write them: no paint of an artist.
TEST(ReadScene, ColoursHiddenInStlLockNothing) {
    const Shell shell = shapes::box();
    std::string stl = "COLOR=";
    stl.append("\0\0\0\xff", 4).resize(80, ' ');
    const auto put = [&](const auto& value) { stl.append(reinterpret_cast<const char*>(&value), sizeof value); };
    put(static_cast<std::uint32_t>(shell.triangles.size()));
    for (const Triangle& t : shell.triangles) {
        for (int i = 0; i < 3; ++i) put(0.0f);
        for (const Index v : t) {
            for (int axis = 0; axis < 3; ++axis) put(static_cast<float>(shell.positions[v][axis]));
        }
        put(static_cast<std::uint16_t>(0x8000));
    }
    const TempFolder folder;
    const Result result = import_shell(folder.write("box.stl", stl));
    EXPECT_EQ(result.report.locked, 0u);
    EXPECT_TRUE(has(result.report, "LOCK_NOTHING_PAINTED"));
    EXPECT_EQ(result.asset.shell.positions.size(), 8u);
}

// A damaged copy of a good file is read or refused, never worse.
void expect_no_crash(const std::string& extension, const std::string& good, std::size_t step) {
    const TempFolder folder;
    const auto try_it = [&](const std::string& bytes, const std::string& what) {
        const auto refusal = refusal_of_file(folder.write("damaged." + extension, bytes));
        EXPECT_TRUE(refusal.message.empty() || refusal.kind == ErrorKind::bad_input) << what << ": " << refusal.message;
    };
    for (std::size_t size = 0; size < good.size(); size += step)
        try_it(good.substr(0, size), "cut at " + std::to_string(size));
    for (std::size_t i = 0; i < good.size(); i += step) {
        std::string bytes = good;
        bytes[i] = static_cast<char>(bytes[i] ^ 0xff);
        try_it(bytes, "byte " + std::to_string(i) + " flipped");
    }
}

TEST(ReadScene, DamagedFilesAreReadOrRefused) {
    const std::string obj = obj_text(shapes::tetrahedron(), [](std::size_t v) { return v ? 1.0 : 0.0; });
    expect_no_crash("obj", obj, 7);
    std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 4\n"
        "property list uchar int vertex_indices\nend_header\n";
    const Shell shell = shapes::tetrahedron();
    const auto put = [&](const auto& value) { ply.append(reinterpret_cast<const char*>(&value), sizeof value); };
    for (const Vec3& p : shell.positions) {
        for (int axis = 0; axis < 3; ++axis) put(static_cast<float>(p[axis]));
        ply.append("\0\xff\xff", 3);
    }
    for (const Triangle& t : shell.triangles) {
        ply.push_back(3);
        for (const Index v : t) put(v);
    }
    expect_no_crash("ply", ply, 7);
    const std::string stl =
        "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid s\n";
    expect_no_crash("stl", stl, 11);
}

TEST(ReadScene, WhatIsWrongWithACoordinateIsSaidWithItsLine) {
    const TempFolder folder;
    const auto message = [&](const std::string& name, const std::string& text) {
        const auto refusal = refusal_of_file(folder.write(name, text));
        EXPECT_EQ(refusal.kind, ErrorKind::bad_input);
        return refusal.message;
    };
    const std::string faces = "v 0 1 0\nv 0 0 1\nf 1 2 3\n";
    EXPECT_TRUE(contains(message("a.obj", "v 0 0 0\nv nan 0 0\n" + faces), "line 2: coordinate 'nan' is not a number"));
    EXPECT_TRUE(contains(message("a.obj", "v 0 0 0\nv 1e300 0 0\n" + faces), "line 2: coordinate '1e300' is beyond"));
    EXPECT_TRUE(contains(message("a.obj", "v 0 0 0\nv 1 0 -inf\n" + faces), "line 2: coordinate '-inf' is not finite"));
    const std::string off = "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1e39 0\n0 0 1\n3 0 1 2\n";
    EXPECT_TRUE(contains(message("a.off", off), "line 5: a coordinate is beyond the range of a float"));
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
        "1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n";
    EXPECT_TRUE(contains(message("a.ply", ply), "coordinate z of vertex 1 is not a number"));
}

TEST(ReadScene, PointsWithoutFacesAndFacesCutShortAreSaidInPlainWords) {
    const TempFolder folder;
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    const auto message = [&](const std::string& text) { return refusal_of_file(folder.write("a.obj", text)).message; };
    EXPECT_TRUE(contains(message(vertices), "no faces, only points")) << message(vertices);
    EXPECT_TRUE(contains(message(vertices + "p 1 2 3\n"), "no faces"));
    EXPECT_TRUE(contains(message(vertices + "f 1 3 2\nf 2 3"), "line 6: an `f` line of 2 corners"));
    EXPECT_TRUE(contains(message(vertices + "f 1 3 2\nf 2 3 5\n"), "line 6: a face refers to vertex 5 of 4"));
    EXPECT_TRUE(contains(message(vertices + "f 1 3 -5\n"), "line 5: a face refers to vertex -5 of 4"));
    EXPECT_TRUE(contains(message(vertices + "f 1 3 0\n"), "line 5: a face refers to vertex 0 of 4"));
    EXPECT_TRUE(contains(message(vertices + "f 1 3 x\n"), "line 5: 'x' is no corner"));
    EXPECT_TRUE(contains(message("f 1 2 3\n" + vertices.substr(0, 16)), "line 1: a face refers to vertex 3 of 2"));
}

TEST(ReadScene, ADryRunWantsFacesWhereImportDoes) {
    const TempFolder folder;
    const std::string ply = folder.write("a.ply",
                                         "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                                         "property float y\nproperty float z\nend_header\n0 0 0\n");
    const std::string off = folder.write("a.off", "OFF\n1 0 0\n0 0 0\n");
    Sources sources;
    sources.shell = folder.write("shell.obj", obj_text(shapes::box()));
    for (const std::string& path : {ply, off}) {
        sources.visuals = {{"", path}};
        EXPECT_TRUE(contains(test::refusal_of([&] { look_at_inputs(sources); }).message, "has no faces")) << path;
        EXPECT_TRUE(contains(test::refusal_of([&] { (void)import_asset(sources); }).message, "has no faces")) << path;
    }
}

TEST(ReadScene, AFaceOfVeryManyCornersIsNamed) {
    constexpr int corners = 32768;
    std::string obj;
    std::string face = "f";
    for (int i = 0; i < corners; ++i) {
        obj += "v " + std::to_string(i) + " " + std::to_string(i * i % 1000) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    const TempFolder folder;
    EXPECT_TRUE(contains(refusal_of_file(folder.write("a.obj", obj + face + "\n")).message, "more than 32767 corners"));
}

TEST(ReadScene, AShellThatItsUnitMakesEmptySaysSo) {
    const TempFolder folder;
    Params params;
    params.unit = 1e-300;
    const auto refusal = refusal_of_file(folder.write("a.obj", obj_text(shapes::box())), params);
    EXPECT_TRUE(contains(refusal.message, "read at 1e-300 m a unit of the file")) << refusal.message;
}

}
}
