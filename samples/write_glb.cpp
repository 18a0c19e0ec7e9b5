// SPDX-License-Identifier: MIT
// The few pieces of glTF 2.0 that a static mesh with vertex colours needs
// [Khronos Group 2021, glTF 2.0 specification, sections 3.6, 3.7, 4.4].
#include <algorithm>
#include <charconv>

#include "samples/little_endian.h"
#include "samples/write.h"

namespace crumple::samples {
namespace {

constexpr int unsigned_byte = 5121;
constexpr int unsigned_int = 5125;
constexpr int floating = 5126;
constexpr int array_buffer = 34962;
constexpr int element_array_buffer = 34963;

// Collects the JSON lists while the binary chunk grows. Every accessor has a view of its own.
struct Gltf {
    std::string binary;
    std::string views;
    std::string accessors;
    std::string meshes;
    std::string nodes;
    int accessor_count = 0;
};

void append_item(std::string& list, const std::string& item) {
    if (!list.empty()) list += ',';
    list += item;
}

std::string number(double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, static_cast<float>(value)).ptr;
    return std::string(digits, end);
}

std::string vector(Vec3 v) { return '[' + number(v.x) + ',' + number(v.y) + ',' + number(v.z) + ']'; }

int add_accessor(Gltf& gltf, std::size_t begin, int target, int component, std::size_t count, const std::string& rest) {
    append_item(gltf.views, "{\"buffer\":0,\"byteOffset\":" + std::to_string(begin) +
                                ",\"byteLength\":" + std::to_string(gltf.binary.size() - begin) +
                                ",\"target\":" + std::to_string(target) + '}');
    append_item(gltf.accessors, "{\"bufferView\":" + std::to_string(gltf.accessor_count) +
                                    ",\"componentType\":" + std::to_string(component) +
                                    ",\"count\":" + std::to_string(count) + ',' + rest + '}');
    return gltf.accessor_count++;
}

int add_positions(Gltf& gltf, const Part& part) {
    const auto begin = gltf.binary.size();
    Vec3 low = part.positions.front();
    Vec3 high = low;
    for (const auto& p : part.positions) {
        for (int axis = 0; axis < 3; ++axis) {
            append_float(gltf.binary, p[axis]);
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    return add_accessor(gltf, begin, array_buffer, floating, part.positions.size(),
                        "\"type\":\"VEC3\",\"min\":" + vector(low) + ",\"max\":" + vector(high));
}

int add_colors(Gltf& gltf, const Part& part) {
    const auto begin = gltf.binary.size();
    for (const auto& color : part.colors) {
        for (const auto channel : color) gltf.binary += static_cast<char>(channel);
    }
    return add_accessor(gltf, begin, array_buffer, unsigned_byte, part.colors.size(),
                        "\"type\":\"VEC4\",\"normalized\":true");
}

int add_indices(Gltf& gltf, const Part& part) {
    const auto begin = gltf.binary.size();
    for (const auto& triangle : part.triangles) {
        for (const auto corner : triangle) append_u32(gltf.binary, corner);
    }
    return add_accessor(gltf, begin, element_array_buffer, unsigned_int, part.triangles.size() * 3,
                        "\"type\":\"SCALAR\"");
}

void add_part(Gltf& gltf, const Part& part, std::size_t number) {
    std::string attributes = "\"POSITION\":" + std::to_string(add_positions(gltf, part));
    if (!part.colors.empty()) attributes += ",\"COLOR_0\":" + std::to_string(add_colors(gltf, part));
    const int indices = add_indices(gltf, part);
    append_item(gltf.meshes, "{\"name\":\"" + part.name + "\",\"primitives\":[{\"attributes\":{" + attributes +
                                 "},\"indices\":" + std::to_string(indices) + "}]}");
    append_item(gltf.nodes, "{\"name\":\"" + part.name + "\",\"mesh\":" + std::to_string(number) + '}');
}

std::string json_of(const Gltf& gltf, std::size_t part_count) {
    std::string roots;
    for (std::size_t i = 0; i < part_count; ++i) append_item(roots, std::to_string(i));
    return "{\"asset\":{\"version\":\"2.0\",\"generator\":\"crumple dev "
           "sample\"},\"scene\":0,\"scenes\":[{\"nodes\":[" +
           roots + "]}],\"nodes\":[" + gltf.nodes + "],\"meshes\":[" + gltf.meshes + "],\"accessors\":[" +
           gltf.accessors + "],\"bufferViews\":[" + gltf.views +
           "],\"buffers\":[{\"byteLength\":" + std::to_string(gltf.binary.size()) + "}]}";
}

void append_chunk(std::string& bytes, std::uint32_t kind, const std::string& content) {
    append_u32(bytes, static_cast<std::uint32_t>(content.size()));
    append_u32(bytes, kind);
    bytes += content;
}

}

std::string glb_bytes(const Model& model) {
    Gltf gltf;
    for (std::size_t i = 0; i < model.size(); ++i) add_part(gltf, model[i], i);
    std::string json = json_of(gltf, model.size());
    while (json.size() % 4 != 0) json += ' ';  // chunks are padded to four bytes; every array of ours already is

    std::string bytes = "glTF";
    append_u32(bytes, 2);
    append_u32(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + gltf.binary.size()));
    append_chunk(bytes, 0x4e4f534a, json);  // "JSON"
    append_chunk(bytes, 0x004e4942, gltf.binary);
    return bytes;
}

}
