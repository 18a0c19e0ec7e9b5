// SPDX-License-Identifier: GPL-3.0-or-later
// What of a PLY file is a surface and its paint, written as PLY again: little-endian, vertices as floats before faces.
// assimp's own reading of other elements, orders and types of numbers loses its place in the file, and with it locks.
#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "core/vec3.h"
#include "formats/color.h"

namespace crumple::formats::ply {

class SurfaceWriter {
public:
    explicit SurfaceWriter(bool has_colors) : has_colors_(has_colors) {}

    void add_vertex(Vec3f position, const Color& color);
    void add_face(std::span<const std::uint32_t> corners);
    [[nodiscard]] std::string take();

private:
    bool has_colors_;
    std::uint64_t vertex_count_ = 0;
    std::uint64_t face_count_ = 0;
    std::string vertices_;
    std::string faces_;
};

}
