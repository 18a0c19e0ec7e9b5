// SPDX-License-Identifier: MIT
// Plain triangle meshes as the generators build them and the writers write them.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple::samples {

using Color = std::array<std::uint8_t, 4>;  // linear RGBA; red 0 locks a vertex

inline constexpr Color unlocked = {255, 255, 255, 255};
inline constexpr Color locked = {0, 96, 255, 255};

// One named object. V vertices, F triangles.
struct Part {
    std::string name;
    std::vector<Vec3> positions;      // V, metres, float-representable, Y up, the car looks along +Z
    std::vector<Color> colors;        // V or empty
    std::vector<Triangle> triangles;  // F, counter-clockwise from outside
};

using Model = std::vector<Part>;

[[nodiscard]] std::size_t vertex_count(const Model& model);
[[nodiscard]] std::size_t triangle_count(const Model& model);
[[nodiscard]] std::size_t locked_count(const Model& model);

// Index of the new vertex. Rounds to float, so that every format states the same position.
Index add_vertex(Part& part, Vec3 position, Color color);

// Two triangles, counter-clockwise, cut along the shorter diagonal (the first on a tie).
void add_quad(Part& part, Index a, Index b, Index c, Index d);

// Paints every vertex of the part.
void paint(Part& part, Color color);

}
