// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/index.h"
#include "importer/prescan.h"
#include "importer/printable.h"

namespace crumple::importer {

namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::bad_input, what); }

constexpr std::uint32_t glb_magic = 0x46546c67;   // "glTF"
constexpr std::uint32_t json_chunk = 0x4e4f534a;  // "JSON"
constexpr std::size_t glb_header_size = 12;
constexpr std::size_t chunk_header_size = 8;

std::uint32_t u32_at(std::string_view bytes, std::size_t offset) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

bool is_binary(std::string_view bytes) { return bytes.size() >= 4 && u32_at(bytes, 0) == glb_magic; }

// The JSON chunk of a binary file, after the sizes were found to fit.
std::string_view json_of_binary(std::string_view bytes) {
    if (bytes.size() < glb_header_size + chunk_header_size) refuse("the file ends within its header");
    if (u32_at(bytes, 4) != 2)
        refuse("glTF version " + std::to_string(u32_at(bytes, 4)) + " is not read; export glTF 2.0");
    if (u32_at(bytes, 8) > bytes.size()) {
        refuse("the header announces " + std::to_string(u32_at(bytes, 8)) + " bytes, the file has " +
               std::to_string(bytes.size()));
    }
    const std::size_t size = u32_at(bytes, glb_header_size);
    if (u32_at(bytes, glb_header_size + 4) != json_chunk) refuse("the first chunk is not JSON");
    if (size > bytes.size() - glb_header_size - chunk_header_size) refuse("the JSON chunk is longer than the file");
    return bytes.substr(glb_header_size + chunk_header_size, size);
}

Json parse(std::string_view text) {
    Json document = Json::parse(text, nullptr, false);
    if (!document.is_object()) refuse("the JSON is damaged");
    return document;
}

const Json& list(const Json& document, const char* name) {
    static const Json empty = Json::array();
    const auto found = document.find(name);
    if (found == document.end()) return empty;
    if (!found->is_array()) refuse(std::string(name) + " is not a list");
    return *found;
}

// A non-negative whole number, or the value given where the key is absent.
std::uint64_t number(const Json& object, const char* name, std::uint64_t absent) {
    if (!object.is_object()) refuse(std::string("an object with '") + name + "' was expected");
    const auto found = object.find(name);
    if (found == object.end()) return absent;
    constexpr std::uint64_t most = std::uint64_t{1} << 48;  // sums and products of these stay in 64 bits
    if (!found->is_number_unsigned() || found->get<std::uint64_t>() > most)
        refuse(std::string(name) + " is not a size");
    return found->get<std::uint64_t>();
}

constexpr std::uint64_t component_float = 5126;

std::uint64_t component_size(std::uint64_t type) {
    switch (type) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            refuse("an accessor has the unknown component type " + std::to_string(type));
    }
}

std::uint64_t component_count(const Json& accessor) {
    const auto found = accessor.find("type");
    const std::string type = found != accessor.end() && found->is_string() ? found->get<std::string>() : "";
    constexpr std::pair<const char*, std::uint64_t> counts[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                                {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
    for (const auto& [name, count] : counts) {
        if (type == name) return count;
    }
    refuse("an accessor has no known type");
}

void check_view(const Json& document, const Json& view, std::size_t index) {
    const Json& buffers = list(document, "buffers");
    const std::uint64_t buffer = number(view, "buffer", none);
    if (buffer >= buffers.size()) refuse("buffer view " + std::to_string(index) + " refers to no buffer");
    const std::uint64_t size = number(buffers[buffer], "byteLength", 0);
    if (number(view, "byteOffset", 0) + number(view, "byteLength", 0) > size) {
        refuse("buffer view " + std::to_string(index) + " reaches beyond its buffer of " + std::to_string(size) +
               " bytes");
    }
}

void check_accessor(const Json& document, const Json& accessor, std::size_t index) {
    const std::uint64_t count = number(accessor, "count", 0);
    const std::uint64_t element = component_size(number(accessor, "componentType", 0)) * component_count(accessor);
    const std::uint64_t view_index = number(accessor, "bufferView", none);
    if (view_index == none || count == 0) return;  // zeros, or a sparse accessor
    const Json& views = list(document, "bufferViews");
    if (view_index >= views.size()) refuse("accessor " + std::to_string(index) + " refers to no buffer view");
    const std::uint64_t stride = number(views[view_index], "byteStride", element);
    constexpr std::uint64_t most = std::uint64_t{1} << 15;
    if (stride > most || count > (std::uint64_t{1} << 40))
        refuse("accessor " + std::to_string(index) + " is too large");
    const std::uint64_t end = number(accessor, "byteOffset", 0) + stride * (count - 1) + element;
    if (end > number(views[view_index], "byteLength", 0)) {
        refuse("accessor " + std::to_string(index) + " reaches beyond its buffer view");
    }
}

// `count` real numbers under a key, or those given where the key is absent.
template <std::size_t count>
std::array<double, count> reals(const Json& object, const char* name, std::array<double, count> values) {
    const auto found = object.find(name);
    if (found == object.end()) return values;
    const bool fits = found->is_array() && found->size() == count &&
                      std::all_of(found->begin(), found->end(), [](const Json& value) { return value.is_number(); });
    if (!fits) refuse(std::string("a node's ") + name + " is not " + std::to_string(count) + " numbers");
    for (std::size_t i = 0; i < count; ++i) values[i] = (*found)[i].get<double>();
    return values;
}

// glTF 2.0, section 3.5.3: a column-major matrix, or translation * rotation * scale.
Affine transform_of(const Json& node) {
    if (!node.is_object()) refuse("a node is not an object");
    if (node.contains("matrix")) {
        const auto m = reals<16>(node, "matrix", {});
        return {m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14]};
    }
    const auto t = reals<3>(node, "translation", {0, 0, 0});
    const auto [x, y, z, w] = reals<4>(node, "rotation", {0, 0, 0, 1});
    const auto s = reals<3>(node, "scale", {1, 1, 1});
    return {s[0] * (1 - 2 * (y * y + z * z)), s[1] * 2 * (x * y - z * w),       s[2] * 2 * (x * z + y * w),       t[0],
            s[0] * 2 * (x * y + z * w),       s[1] * (1 - 2 * (x * x + z * z)), s[2] * 2 * (y * z - x * w),       t[1],
            s[0] * 2 * (x * z - y * w),       s[1] * 2 * (y * z + x * w),       s[2] * (1 - 2 * (x * x + y * y)), t[2]};
}

void check_version(const Json& document) {
    const auto asset = document.find("asset");
    const bool is_there = asset != document.end() && asset->is_object() && asset->contains("version");
    const Json number = is_there ? (*asset)["version"] : Json();
    if (number.is_string() && number.get<std::string>().starts_with("2.")) return;
    refuse("glTF version " + in_quotes(number.is_string() ? number.get<std::string>() : "") +
           " is not read (its colours would be lost); export glTF 2.0");
}

const Json& accessor_at(const Json& document, std::uint64_t index) {
    const Json& accessors = list(document, "accessors");
    if (index < accessors.size()) return accessors[index];
    refuse("a primitive refers to accessor " + std::to_string(index) + ", which is not there");
}

// assimp copies positions as floats whatever they are, and leaves out colours of another count without a word.
void check_attributes(const Json& document, const Json& attributes) {
    if (!attributes.is_object()) refuse("a primitive's attributes are not an object");
    const std::uint64_t position = number(attributes, "POSITION", none);
    if (position == none) return;
    const Json& positions = accessor_at(document, position);
    if (number(positions, "componentType", 0) != component_float || component_count(positions) != 3) {
        refuse("positions are not three floats (quantized?); export without compression");
    }
    for (const auto& [name, accessor] : attributes.items()) {
        if (!name.starts_with("COLOR_")) continue;
        const std::uint64_t colors = number(accessor_at(document, number(attributes, name.c_str(), none)), "count", 0);
        if (colors != number(positions, "count", 0)) {
            refuse(name + " holds " + std::to_string(colors) + " colours for " +
                   std::to_string(number(positions, "count", 0)) + " vertices");
        }
    }
}

std::uint64_t triangles_of(const Json& document, const Json& primitive) {
    constexpr std::uint64_t triangles_mode = 4;  // below: points and lines; above: strips and fans
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end()) refuse("a primitive has no attributes");
    check_attributes(document, *attributes);
    const std::uint64_t mode = number(primitive, "mode", triangles_mode);
    const std::uint64_t position = number(*attributes, "POSITION", none);
    const std::uint64_t indices = number(primitive, "indices", none);
    if (position == none || mode < triangles_mode) return 0;
    const std::uint64_t corners = number(accessor_at(document, indices == none ? position : indices), "count", 0);
    if (mode == triangles_mode) return corners / 3;
    return corners >= 3 ? corners - 2 : 0;
}

// Extensions that change how geometry is stored and that assimp does not know; it would read noise.
void check_extensions(const Json& document) {
    for (const Json& name : list(document, "extensionsRequired")) {
        for (const char* unread : {"KHR_mesh_quantization", "EXT_meshopt_compression", "KHR_meshopt_compression"}) {
            if (name == unread) refuse(std::string("it needs ") + unread + ", which is not read; export without it");
        }
    }
}

}

Prescan prescan_gltf(std::string_view bytes) {
    const Json document = parse(is_binary(bytes) ? json_of_binary(bytes) : bytes);
    check_version(document);
    check_extensions(document);
    const Json& views = list(document, "bufferViews");
    for (std::size_t i = 0; i < views.size(); ++i) check_view(document, views[i], i);
    const Json& accessors = list(document, "accessors");
    for (std::size_t i = 0; i < accessors.size(); ++i) check_accessor(document, accessors[i], i);

    Prescan result;
    const Json& nodes = list(document, "nodes");
    for (const Json& node : nodes) result.transforms.push_back(transform_of(node));
    const Json& meshes = list(document, "meshes");
    for (const Json& mesh : meshes) {
        if (!mesh.is_object()) refuse("a mesh is not an object");
        for (const Json& primitive : list(mesh, "primitives")) {
            if (!primitive.is_object()) refuse("a primitive is not an object");
            result.expected_triangles += triangles_of(document, primitive);
        }
    }
    return result;
}

}
