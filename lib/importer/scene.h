// SPDX-License-Identifier: GPL-3.0-or-later
// What the reading child hands over: meshes and the nodes that place them, in plain arrays, and the bytes they travel
// in.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"
#include "importer/import.h"

namespace crumple::importer {

using Color = std::array<float, 4>;
using Affine = std::array<double, 12>;  // 3 x 4 row-major

struct SceneMesh {
    std::string name;
    std::string material;
    std::vector<Vec3f> positions;            // V
    std::vector<Triangle> triangles;         // indices below V
    std::vector<std::vector<Color>> colors;  // one entry a colour set: V, or empty where this mesh lacks it
    std::vector<Index> file_vertex;          // V: row of Scene::file_positions; empty where that is
    std::uint64_t points_and_lines = 0;      // dropped by the reader
    std::uint64_t unreadable_polygons = 0;
};

struct SceneNode {
    std::string name;
    Index parent = none;                                   // an earlier node
    Affine transform{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};  // to the parent's space
    std::vector<Index> meshes;
};

// What of a file is not read, and nobody is told otherwise.
struct Unread {
    std::uint64_t bytes = 0;              // behind what its header announces (PLY, binary glTF)
    std::uint64_t free_form = 0;          // curves and surfaces that are not polygons (OBJ)
    std::uint64_t points_and_lines = 0;   // OBJ; of other formats assimp counts them, see SceneMesh
    std::uint64_t colored_faces = 0;      // with a colour of their own (PLY, OFF, FBX)
    std::uint64_t polypaint = 0;          // vertices with a colour in comments of ZBrush (OBJ)
    std::uint64_t nodes = 0;              // with a mesh, outside the scene that is read (glTF)
    std::uint64_t nodes_of_no_scene = 0;  // read although no scene says so (glTF)
    std::uint64_t skins = 0;              // nodes whose mesh joints would move (glTF)
    std::uint64_t morphs = 0;             // meshes and nodes that mix in morph targets from the start (glTF)
};

struct Scene {
    std::string generator;  // the program that wrote the file, as the file says, may be empty
    double unit = 0;        // metres per unit as the file says, 0: it does not say
    Up up = Up::automatic;  // as the file says, automatic: it does not say
    std::array<double, 9> axes{1, 0, 0, 0, 1, 0, 0, 0, 1};  // 3 x 3 row-major: from the file's axes to Y up
    std::uint64_t expected_triangles = 0;  // by the file's own count of polygon corners, 0: not counted
    Unread unread;
    std::vector<std::string> extensions;  // that the file requires, and that say nothing of surface and paint (glTF)
    std::vector<Vec3f> file_positions;  // the file's vertex list where it is indexed apart from faces (OBJ), else empty
    std::vector<float> file_reds;       // of file_positions as the file states them, or empty: it has no colours
    std::vector<SceneMesh> meshes;
    std::vector<SceneNode> nodes;
};

// From a file with that axis up to Y up, 3 x 3 row-major; the identity for automatic.
[[nodiscard]] std::array<double, 9> axes_of(Up up);

[[nodiscard]] std::vector<std::byte> encode(const Scene& scene);

// Trusts nothing: every count, index and number is checked, names are made printable UTF-8.
// Throws Error(bad_input) for bytes that are no scene.
[[nodiscard]] Scene decode(std::span<const std::byte> bytes);

}
