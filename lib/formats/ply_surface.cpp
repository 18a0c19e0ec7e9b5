// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/ply_surface.h"

#include <initializer_list>

namespace crumple::formats::ply {

namespace {

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string properties(std::initializer_list<const char*> names) {
    std::string text;
    for (const char* name : names) text += std::string("property float ") + name + "\n";
    return text;
}

}

void SurfaceWriter::add_vertex(Vec3f position, const Color& color) {
    append(vertices_, position);
    if (has_colors_) append(vertices_, color);
    ++vertex_count_;
}

void SurfaceWriter::add_face(std::span<const std::uint32_t> corners) {
    append(faces_, static_cast<std::uint32_t>(corners.size()));
    for (const std::uint32_t corner : corners) append(faces_, corner);
    ++face_count_;
}

std::string SurfaceWriter::take() {
    std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertex_count_) + "\n" +
                       properties({"x", "y", "z"});
    if (has_colors_) file += properties({"red", "green", "blue", "alpha"});
    file += "element face " + std::to_string(face_count_) + "\nproperty list uint uint vertex_indices\nend_header\n";
    file += vertices_;
    file += faces_;
    return file;
}

}
