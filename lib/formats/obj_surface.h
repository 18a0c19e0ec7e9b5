// SPDX-License-Identifier: GPL-3.0-or-later
// What of an OBJ file is a surface and its paint, written as OBJ again: one statement a line, plain numbers, corners
// that are vertex numbers from 1. assimp passes over vertices that are indented or whose numbers begin with a point,
// tells by them whether a vertex has a colour, and gives the corners of lines a colour of 0: each loses or makes locks.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/vec3.h"

namespace crumple::formats::obj {

// What assimp's parser makes of a vertex that was written.
struct AsRead {
    Vec3f position;
    float red = 0;  // 0 without a colour
};

class SurfaceWriter {
public:
    AsRead add_vertex(Vec3f position, const std::optional<Vec3f>& color);
    void add_face(std::span<const std::uint64_t> corners);  // from 0
    // An object, group, material or material file, as its line has it: they part a surface and name its parts.
    void add_statement(std::string_view keyword, std::string_view rest);
    [[nodiscard]] std::string take();

private:
    float append(float value);

    std::string text_;
};

}
