// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/import.h"

#include <sys/stat.h>

#include <atomic>

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

Result import_obj(const Shell& shell, const Params& params = {}) {
    const TempFolder folder;
    return import_shell(folder.write("shell.obj", obj_text(shell)), params);
}

Shell two(const Shell& a, const Shell& b) { return shapes::joined(a, b); }

TEST(Import, PathThatCannotBeOpenedIsAFileError) {
    const TempFolder folder;
    EXPECT_EQ(refusal_of_file((folder.path() / "absent.obj").string()).kind, ErrorKind::file);
    EXPECT_EQ(refusal_of_file("").kind, ErrorKind::file);
    EXPECT_EQ(refusal_of_file(folder.path().string()).kind, ErrorKind::file);
    const std::string pipe = (folder.path() / "pipe.obj").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(refusal_of_file(pipe).kind, ErrorKind::file);
}

TEST(Import, UnknownExtensionSaysWhichFormatsWork) {
    const TempFolder folder;
    for (const char* name : {"a.blend", "a", "a.obj.txt", ".obj"}) {
        const auto refusal = refusal_of_file(folder.write(name, "v 0 0 0\n"));
        EXPECT_EQ(refusal.kind, ErrorKind::bad_input) << name;
        EXPECT_TRUE(contains(refusal.message, ".obj, .ply, .off, .stl, .gltf, .glb, .dae, .fbx, .x"))
            << refusal.message;
    }
}

TEST(Import, ExtensionIsReadInAnyCase) {
    const TempFolder folder;
    EXPECT_EQ(import_shell(folder.write("A.OBJ", obj_text(shapes::box()))).report.shell.format, "Wavefront OBJ");
}

TEST(Import, EmptyAndForeignContentIsRefusedInEveryFormat) {
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

TEST(Import, WhatEditorsAndVersionControlMakeOfAFile) {
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

TEST(Import, WhatIsNotReadIsTold) {
    const TempFolder folder;
    const Result curves =
        import_shell(folder.write("a.obj", obj_text(shapes::box()) + "curv 0 1 1 2 3\nsurf 0 1 0 1 1\n"));
    EXPECT_EQ(find(curves.report.findings, "FILE_FREE_FORM")->count, 2u);
    const std::string ply = ply_text(" 0 255 255", "\n");
    EXPECT_FALSE(has(import_shell(folder.write("a.ply", ply + "\n")).report, "FILE_UNREAD"));
    EXPECT_EQ(find(import_shell(folder.write("a.ply", ply + "3 0 1 2\n")).report.findings, "FILE_UNREAD")->count, 8u);
}

// assimp reads a line where we read numbers, takes "+255" for 0, and loses its place at elements before the vertices.
TEST(Import, APlyIsReadAsItsHeaderSays) {
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

TEST(Import, FacesOfAPlyMayHaveAnyNumberOfCorners) {
    const TempFolder folder;
    std::string ply = ply_text(" 0 255 255", "\n");
    ply.replace(ply.find("face 12"), 7, "face 15");
    const Result result = import_shell(folder.write("a.ply", ply + "0\n1 3\n2 0 1\n"));
    EXPECT_EQ(result.report.triangles, 12u);
    EXPECT_EQ(result.report.shell.points_and_lines, 2u);
}

TEST(Import, AFileWithoutFacesIsRefusedByALookAtItsBytesToo) {
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

TEST(Import, PaintThatIsNoVertexsIsToldWhereNoVertexHasAny) {
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
    for (const Vec3& p : shapes::box().positions)
        append(Vec3f{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    for (const Triangle& t : shapes::box().triangles) {
        for (const Index v : t) append(static_cast<std::uint16_t>(v));
    }
    return bytes;
}

TEST(Import, AGltfWithoutScenesIsALibraryOfWhatItHolds) {
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

TEST(Import, AGltfIsWhatItsBytesAreWhateverItIsCalled) {
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

TEST(Import, OddPaintOfAVisualMeshDoesNotMatter) {
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

// How many triangles of a box of some size and a changed copy of it lie nearly on another one.
template <class Change>
std::uint64_t nearly_double(double size, const Change& change) {
    const Shell box = shapes::subdivided_box(4);
    Shell copy = box;
    for (Vec3& p : copy.positions) p = change(p);
    Shell both = two(box, copy);
    for (Vec3& p : both.positions) p = p * size;
    const Result result = import_obj(both);
    const Finding* finding = find(result.report.findings, "SHELL_NEARLY_DOUBLE");
    return finding ? finding->count : 0;
}

TEST(Import, ACopyOfASurfaceNearItIsTold) {
    const std::uint64_t all = 2 * shapes::subdivided_box(4).triangles.size();
    for (const double size : {1.0, 1e-3, 1e4}) {
        EXPECT_EQ(nearly_double(size, [](Vec3 p) { return p * (1 - 2e-6) + Vec3{1e-6, 1e-6, 1e-6}; }), all);
        EXPECT_GT(nearly_double(size, [](Vec3 p) { return p + Vec3{1e-6, 1e-6, 1e-6}; }), all / 2) << "they cross";
        EXPECT_EQ(nearly_double(size, [](Vec3 p) { return p + Vec3{1e-2, 1e-2, 1e-2}; }), 0u);
        EXPECT_EQ(nearly_double(size, [](Vec3 p) { return p + Vec3{1 + 1e-6, 0, 0}; }), 0u) << "solids that touch";
    }
}

TEST(Import, MaterialsKeepTheirNamesThoughTheirLibraryIsNotRead) {
    const TempFolder folder;
    (void)folder.write("a.mtl", "newmtl steel\nnewmtl other\n");
    const std::string path = folder.write("a.obj", "mtllib a.mtl\nusemtl steel\n" + obj_text(shapes::box()));
    EXPECT_EQ(import_shell(path).report.components.at(0).material, "steel");
}

TEST(Import, BoxComesThroughAsItIs) {
    const Result result = import_obj(shapes::box());
    EXPECT_EQ(result.asset.shell.positions, shapes::box().positions);
    EXPECT_EQ(result.asset.shell.triangles, shapes::box().triangles);
    EXPECT_EQ(result.report.vertices, 8u);
    EXPECT_EQ(result.report.triangles, 12u);
    EXPECT_EQ(result.report.shell.vertices, 8u);
    EXPECT_EQ(result.report.shell.up, "y");
    EXPECT_EQ(result.asset.shell.component, std::vector<Index>(12, 0));
    EXPECT_EQ(result.asset.shell.locked, std::vector<std::uint8_t>(8, 0));
    EXPECT_TRUE(result.asset.locked_positions.empty());
}

TEST(Import, PolygonsAreSplitAndPointsAndLinesCounted) {
    const TempFolder folder;
    const std::string quads =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nl 1 7\np 3\n";
    const Result result = import_shell(folder.write("quads.obj", quads));
    EXPECT_EQ(result.report.triangles, 12u);
    EXPECT_DOUBLE_EQ(result.report.components.at(0).volume, 1);
    EXPECT_EQ(result.report.shell.points_and_lines, 2u);
    EXPECT_TRUE(has(result.report, "FILE_POINTS_AND_LINES"));
    EXPECT_FALSE(has(result.report, "FILE_FACES_LOST"));
}

TEST(Import, WhatEnclosesNothingIsRefused) {
    const TempFolder folder;
    const auto none_at_all = refusal_of_file(folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"));
    EXPECT_EQ(none_at_all.kind, ErrorKind::bad_input);
    EXPECT_TRUE(contains(none_at_all.message, "no faces")) << none_at_all.message;
    const auto flat =
        refusal_of_file(folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n"));
    EXPECT_TRUE(contains(flat.message, "SHELL_FLAT")) << flat.message;
    const auto needles = refusal_of_file(folder.write("needle.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"));
    EXPECT_TRUE(contains(needles.message, "SHELL_EMPTY")) << needles.message;
}

TEST(Import, NonFinitePositionsAreRefused) {
    const TempFolder folder;
    for (const char* number : {"nan", "inf", "1e39", "-1e200"}) {
        const auto refusal =
            refusal_of_file(folder.write("a.obj", std::string("v 0 0 ") + number + "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        EXPECT_EQ(refusal.kind, ErrorKind::bad_input) << number;
        EXPECT_TRUE(contains(refusal.message, "line 1: coordinate")) << refusal.message;
    }
}

TEST(Import, IndicesBeyondTheListAreRefused) {
    const TempFolder folder;
    EXPECT_EQ(refusal_of_file(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")).kind,
              ErrorKind::bad_input);
    EXPECT_EQ(refusal_of_file(folder.write("b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n")).kind,
              ErrorKind::bad_input);
}

struct Case {
    const char* code;
    Shell shell;
};

TEST(Import, EveryKindOfDirtHasItsFinding) {
    const Shell box = shapes::box();
    Shell turned = box;
    std::swap(turned.triangles[0][0], turned.triangles[0][1]);
    Shell twice = box;
    twice.triangles.push_back(box.triangles[5]);
    Shell fin = box;
    fin.positions.push_back({0.5, 0.5, -0.1});
    fin.triangles.push_back({box.triangles[0][0], box.triangles[0][1], 8});
    Shell needle = box;
    needle.positions.insert(needle.positions.end(), {{5, 0, 0}, {6, 0, 0}, {7, 0, 0}});
    needle.triangles.push_back({8, 9, 10});
    Shell folded = shapes::icosphere(1, 2);
    folded.positions[0] = folded.positions[0] * -2.0;
    const Case cases[] = {
        {"SHELL_OPEN", shapes::without_triangle(box)},
        {"SHELL_NON_MANIFOLD", fin},
        {"SHELL_INCONSISTENT", turned},
        {"SHELL_SELF_INTERSECTING", folded},
        {"SHELL_DUPLICATE", twice},
        {"SHELL_DEGENERATE", needle},
        {"SHELL_NESTED", shapes::nested_boxes()},
        {"SHELL_INVERTED", shapes::inverted(box)},
        {"SHELL_OVERLAPPING", two(box, shapes::box({0.5, 0.5, 0.5}, {2, 2, 2}))},
        {"SHELL_FAR_FROM_ORIGIN", shapes::moved(box, {1e5, 0, 0})},
        {"LOCK_NOTHING_PAINTED", box},
    };
    for (const Case& c : cases) {
        const Result result = import_obj(c.shell);
        const Finding* finding = find(result.report.findings, c.code);
        ASSERT_NE(finding, nullptr) << c.code;
        EXPECT_GT(finding->count, 0u) << c.code;
        EXPECT_FALSE(finding->message.empty()) << c.code;
        EXPECT_FALSE(finding->places.empty()) << c.code;
        EXPECT_LE(finding->places.size(), max_places) << c.code;
    }
}

TEST(Import, NearlyEverythingPaintedIsReported) {
    const TempFolder folder;
    const Shell sphere = shapes::icosphere(1, 2);
    const auto all = import_shell(folder.write("all.obj", obj_text(sphere, [](std::size_t) { return 0.0; })));
    EXPECT_TRUE(has(all.report, "LOCK_NEARLY_ALL"));
    EXPECT_EQ(all.asset.locked_positions, test::sorted(sphere.positions));
    const auto half =
        import_shell(folder.write("half.obj", obj_text(sphere, [](std::size_t v) { return v % 2 ? 0.0 : 1.0; })));
    EXPECT_FALSE(has(half.report, "LOCK_NEARLY_ALL"));
    EXPECT_FALSE(has(half.report, "LOCK_NOTHING_PAINTED"));
    EXPECT_EQ(half.report.locked, sphere.positions.size() / 2);
}

TEST(Import, VisualMeshesKeepNamesOrderAndEveryVertex) {
    const TempFolder folder;
    const std::string shell = folder.write("shell.obj", obj_text(shapes::box()));
    const std::string list = "v 9 9 9\nv 0 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 4 5\n";
    Sources sources{shell,
                    {{"body", folder.write("a.obj", list)}, {"", folder.write("wheel.obj", obj_text(shapes::box()))}}};
    const Result result = import_asset(sources);
    ASSERT_EQ(result.asset.visuals.size(), 2u);
    EXPECT_EQ(result.asset.visuals[0].name, "body");
    EXPECT_EQ(result.asset.visuals[0].positions.size(), 5u);
    EXPECT_EQ(result.asset.visuals[0].positions[0], (Vec3{9, 9, 9}));
    EXPECT_EQ(result.asset.visuals[0].source_vertex, (std::vector<Index>{0, 1, 2, 3, 4}));
    EXPECT_EQ(result.asset.visuals[1].name, "wheel");
    EXPECT_EQ(result.report.visuals.at(1).vertices, 8u);
}

TEST(Import, UnitAndUpApplyToShellAndVisualsAlike) {
    const TempFolder folder;
    const std::string path = folder.write("box.obj", obj_text(shapes::box({0, 0, 0}, {1, 2, 3})));
    Params params;
    params.unit = 0.01;
    params.up = Up::z;
    const Result result = import_asset({path, {{"same", path}}}, params);
    EXPECT_EQ(test::sorted(result.asset.shell.positions), test::sorted(result.asset.visuals[0].positions));
    const std::vector<Vec3>& placed = result.asset.visuals[0].positions;
    EXPECT_NE(std::find(placed.begin(), placed.end(), round_to_float({0.01, 0.03, -0.02})), placed.end());
    EXPECT_GT(result.report.components.at(0).volume, 0);
    EXPECT_FALSE(result.report.components.at(0).is_inward);
}

TEST(Import, NamesOfVisualMeshesMustBeUsableAndUnique) {
    const TempFolder folder;
    const std::string path = folder.write("box.obj", obj_text(shapes::box()));
    const auto refusal = [&](const std::string& first, const std::string& second) {
        return test::refusal_of([&] { (void)import_asset({path, {{first, path}, {second, path}}}); });
    };
    EXPECT_EQ(refusal("a", "a").kind, ErrorKind::usage);
    EXPECT_EQ(refusal("", "box").kind, ErrorKind::usage);
    EXPECT_TRUE(contains(refusal("", "").message, "--visual NAME="));
    EXPECT_EQ(refusal("a/b", "c").kind, ErrorKind::usage);
    EXPECT_EQ(refusal("..", "c").kind, ErrorKind::usage);
    EXPECT_EQ(refusal("a\n", "c").kind, ErrorKind::usage);
    EXPECT_TRUE(refusal("a", "b").message.empty());
}

TEST(Import, ErrorsNameTheFileTheyAreAbout) {
    const TempFolder folder;
    const std::string shell = folder.write("shell.obj", obj_text(shapes::box()));
    const std::string broken = folder.write("broken.ply", "ply\n");
    const auto refusal = test::refusal_of([&] { (void)import_asset({shell, {{"", broken}}}); });
    EXPECT_TRUE(refusal.message.starts_with(broken)) << refusal.message;
    const std::string flat = folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_TRUE(refusal_of_file(flat).message.starts_with(flat));
}

TEST(Import, LimitsOfTheReaderBecomeRefusals) {
    const TempFolder folder;
    const std::string path = folder.write("ball.obj", obj_text(shapes::icosphere(1, 6)));
    Params params;
    params.time_s = 0.001;
    const auto late = refusal_of_file(path, params);
    EXPECT_EQ(late.kind, ErrorKind::bad_input);
    EXPECT_TRUE(contains(late.message, "import.time_s")) << late.message;
    params = {};
    params.memory_mb = 1;
    const auto large = refusal_of_file(path, params);
    EXPECT_EQ(large.kind, ErrorKind::bad_input);
}

TEST(Import, CancelledImportStops) {
    const TempFolder folder;
    const std::atomic<bool> cancelled = true;
    Context context;
    context.cancelled = &cancelled;
    const std::string path = folder.write("box.obj", obj_text(shapes::box()));
    EXPECT_EQ(test::refusal_of([&] { (void)import_asset({path, {}}, {}, context); }).kind, ErrorKind::budget);
}

// Black facets and a black default colour, as some programs write them: no paint of an artist.
TEST(Import, ColoursHiddenInStlLockNothing) {
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

TEST(Import, DamagedFilesAreReadOrRefused) {
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

TEST(Import, TwiceIsTheSame) {
    const TempFolder folder;
    const std::string path =
        folder.write("a.obj", obj_text(shapes::nested_boxes(), [](std::size_t v) { return v % 3 ? 1.0 : 0.0; }));
    const Result a = import_shell(path);
    const Result b = import_shell(path);
    EXPECT_EQ(a.asset.shell.positions, b.asset.shell.positions);
    EXPECT_EQ(a.asset.shell.triangles, b.asset.shell.triangles);
    EXPECT_EQ(a.asset.locked_positions, b.asset.locked_positions);
}

// Names every field a visitor is shown.
struct FieldNames {
    std::vector<std::string> names;
    template <class T>
    void field(const char* name, T&, const char*) {
        names.emplace_back(name);
    }
    template <class T>
    void field(const char* name, T&, Range, const char*) {
        names.emplace_back(name);
    }
};

TEST(Import, EveryFieldIsDescribed) {
    const auto names_of = [](auto value) {
        FieldNames visitor;
        describe(visitor, value);
        EXPECT_EQ(std::set<std::string>(visitor.names.begin(), visitor.names.end()).size(), visitor.names.size());
        return visitor.names.size();
    };
    EXPECT_EQ(names_of(Params{}), 11u);
    EXPECT_EQ(names_of(FileReport{}), 10u);
    EXPECT_EQ(names_of(ComponentReport{}), 9u);
    EXPECT_EQ(names_of(Report{}), 26u);
}

TEST(Import, ASizeThatNothingHasNamesTheUnitToTry) {
    const TempFolder folder;
    const auto finding_at = [&](double scale, double unit) {
        const std::string path =
            folder.write("shell.obj", obj_text(shapes::moved(shapes::box({0, 0, 0}, {4, 2, 2}), {0, 0, 0}, scale)));
        Params params;
        params.unit = unit;
        const Result result = import_shell(path, params);
        const Finding* finding = find(result.report.findings, "IMPORT_SIZE_UNUSUAL");
        return finding ? finding->message : std::string();
    };
    EXPECT_EQ(finding_at(1, 0), "");
    EXPECT_EQ(finding_at(100, 0.01), "");
    EXPECT_TRUE(contains(finding_at(100, 0), "489.9 m")) << finding_at(100, 0);
    EXPECT_TRUE(contains(finding_at(100, 0), "--unit 0.01 makes it 4.899 m"));
    EXPECT_TRUE(contains(finding_at(1000, 0), "--unit 0.001 makes it 4.899 m"));
    EXPECT_TRUE(contains(finding_at(1, 0.001), "--unit 1 makes it 4.899 m"));
}

TEST(Import, WhatIsWrongWithACoordinateIsSaidWithItsLine) {
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

TEST(Import, PointsWithoutFacesAndFacesCutShortAreSaidInPlainWords) {
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

}
}
