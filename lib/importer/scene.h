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
#include "formats/color.h"
#include "formats/prescan.h"
#include "importer/import.h"

namespace crumple::importer {

using formats::Color;

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
    Index parent = none;                                            // an earlier node
    formats::Affine transform{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};  // to the parent's space
    std::vector<Index> meshes;
};

struct Scene {
    std::string generator;  // the program that wrote the file, as the file says, may be empty
    double unit = 0;        // metres per unit as the file says, 0: it does not say
    Up up = Up::automatic;  // as the file says, automatic: it does not say
    std::array<double, 9> axes{1, 0, 0, 0, 1, 0, 0, 0, 1};  // 3 x 3 row-major: from the file's axes to Y up
    std::uint64_t expected_triangles = 0;  // by the file's own count of polygon corners, 0: not counted
    formats::Unread unread;
    std::vector<std::string> extensions;  // that the file requires, and that say nothing of surface and paint (glTF)
    std::vector<Vec3f> file_positions;  // the file's vertex list where it is indexed apart from faces (OBJ), else empty
    std::vector<float> file_reds;       // of file_positions as the file states them, or empty: it has no colours
    std::vector<SceneMesh> meshes;
    std::vector<SceneNode> nodes;

    // Triangles by the file's own count that were not delivered.
    [[nodiscard]] std::uint64_t lost_triangles() const;
};

// From a file with that axis up to Y up, 3 x 3 row-major; the identity for automatic.
[[nodiscard]] std::array<double, 9> axes_of(Up up);

[[nodiscard]] std::vector<std::byte> encode(const Scene& scene);

// Trusts nothing: every count, index and number is checked, names are made printable UTF-8.
// Throws Error(bad_input) for bytes that are no scene.
[[nodiscard]] Scene decode(std::span<const std::byte> bytes);

}
