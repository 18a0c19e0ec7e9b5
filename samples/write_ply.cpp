// SPDX-License-Identifier: MIT
#include "samples/little_endian.h"
#include "samples/write.h"

namespace crumple::samples {
namespace {

std::string header(const Model& model) {
    return "ply\nformat binary_little_endian 1.0\ncomment written by crumple dev sample\nelement vertex " +
           std::to_string(vertex_count(model)) +
           "\nproperty float x\nproperty float y\nproperty float z\n"
           "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\nelement face " +
           std::to_string(triangle_count(model)) + "\nproperty list uchar uint vertex_indices\nend_header\n";
}

void append_vertex(std::string& bytes, const Part& part, std::size_t v) {
    for (int axis = 0; axis < 3; ++axis) append_float(bytes, part.positions[v][axis]);
    const Color color = part.colors.empty() ? unlocked : part.colors[v];
    for (const auto channel : color) bytes += static_cast<char>(channel);
}

}

std::string ply_bytes(const Model& model) {
    std::string bytes = header(model);
    for (const auto& part : model) {
        for (std::size_t v = 0; v < part.positions.size(); ++v) append_vertex(bytes, part, v);
    }
    std::uint32_t first = 0;
    for (const auto& part : model) {
        for (const auto& triangle : part.triangles) {
            bytes += '\3';
            for (const auto corner : triangle) append_u32(bytes, first + corner);
        }
        first += static_cast<std::uint32_t>(part.positions.size());
    }
    return bytes;
}

}
