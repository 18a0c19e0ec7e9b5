// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/index.h"
#include "formats/color_name.h"
#include "formats/coordinate.h"
#include "formats/gltf_document.h"
#include "formats/gltf_extensions.h"
#include "formats/gltf_scene.h"
#include "formats/gltf_surface.h"
#include "formats/prescan.h"
#include "formats/printable.h"

namespace crumple::formats {

namespace {

using gltf::Json;
using gltf::list;
using gltf::number;

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::bad_input, what); }

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

// A buffer of a binary file's own chunk, of a data URI or of another file; only the first can be measured here.
void check_buffer(const gltf::Document& document, const Json& buffer, std::size_t index) {
    const std::uint64_t size = number(buffer, "byteLength", 0);
    const std::string name = "buffer " + std::to_string(index);
    const bool is_chunk = document.is_binary && index == 0;
    if (!gltf::uri_of(buffer).empty() || size == 0) return;
    if (!is_chunk) refuse(name + " has no uri; export as .glb, or with its buffers");
    if (size > document.binary.size()) {
        refuse(name + " has " + std::to_string(size) + " bytes, the file's binary chunk " +
               std::to_string(document.binary.size()) + "; the file is damaged or cut short");
    }
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

// `count` elements of so many bytes each lie within a view.
void check_reach(const Json& document, const Json& holder, std::uint64_t count, std::uint64_t element,
                 const std::string& name) {
    const std::uint64_t index = number(holder, "bufferView", none);
    const Json& views = list(document, "bufferViews");
    if (index >= views.size()) refuse(name + " refers to no buffer view");
    std::uint64_t stride = number(views[index], "byteStride", element);
    if (stride == 0) stride = element;
    constexpr std::uint64_t most = std::uint64_t{1} << 15;
    if (stride < element)
        refuse(name + " has elements of " + std::to_string(element) + " bytes, which its buffer view puts " +
               std::to_string(stride) + " bytes apart");
    if (stride > most || count > (std::uint64_t{1} << 40)) refuse(name + " is too large");
    if (number(holder, "byteOffset", 0) + stride * (count - 1) + element > number(views[index], "byteLength", 0))
        refuse(name + " reaches beyond its buffer view");
}

void check_sparse(const Json& document, const Json& sparse, std::uint64_t element, const std::string& name) {
    const std::uint64_t count = number(sparse, "count", 0);
    if (count == 0 || !sparse.contains("indices") || !sparse.contains("values"))
        refuse(name + " is sparse without indices or values");
    const Json& indices = sparse["indices"];
    check_reach(document, indices, count, component_size(number(indices, "componentType", 0)), name + " (sparse)");
    check_reach(document, sparse["values"], count, element, name + " (sparse)");
}

void check_accessor(const Json& document, const Json& accessor, std::size_t index) {
    const std::uint64_t count = number(accessor, "count", 0);
    const std::uint64_t element = component_size(number(accessor, "componentType", 0)) * component_count(accessor);
    const std::string name = "accessor " + std::to_string(index);
    if (count == 0) return;
    if (accessor.contains("sparse")) check_sparse(document, accessor["sparse"], element, name);
    // Without a view it is all zeros, or all in the sparse part.
    if (number(accessor, "bufferView", none) != none) check_reach(document, accessor, count, element, name);
}

// `count` real numbers under a key, or those given where the key is absent.
template <std::size_t count>
std::array<double, count> reals(const Json& object, const char* name, std::array<double, count> values) {
    const auto found = object.find(name);
    if (found == object.end()) return values;
    const bool fits = found->is_array() && found->size() == count &&
                      std::all_of(found->begin(), found->end(), [](const Json& value) { return value.is_number(); });
    if (!fits) refuse(std::string("a node's ") + name + " is not " + std::to_string(count) + " numbers");
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = (*found)[i].get<double>();
        if (!coordinate_fault(values[i]).empty())
            refuse(std::string("a number of a node's ") + name + " " + std::string(coordinate_fault(values[i])));
    }
    return values;
}

// glTF 2.0, section 3.5.3: a column-major matrix, or translation * rotation * scale.
Affine transform_of(const Json& node) {
    if (!node.is_object()) refuse("a node is not an object");
    if (node.contains("matrix")) {
        const auto m = reals<16>(node, "matrix", {});
        const auto is = [&](std::size_t i, float value) { return static_cast<float>(m[i]) == value; };
        if (!is(3, 0) || !is(7, 0) || !is(11, 0) || !is(15, 1))
            refuse("the matrix of a node is not affine: its last row must be 0 0 0 1");
        return {m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14]};
    }
    const auto t = reals<3>(node, "translation", {0, 0, 0});
    const auto [x, y, z, w] = reals<4>(node, "rotation", {0, 0, 0, 1});
    const auto s = reals<3>(node, "scale", {1, 1, 1});
    // Another length would scale and shear what it should only turn.
    constexpr double rounding = 1e-3;
    if (!(std::fabs(x * x + y * y + z * z + w * w - 1) <= rounding))
        refuse("a node's rotation is no unit quaternion");
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

bool is_color_set(std::string_view attribute) { return attribute.starts_with("COLOR_"); }

// glTF 2.0, section 3.7.2.1: floats, or bytes and shorts without a sign. assimp leaves out colours of another type or
// another count without a word.
void check_color_set(const Json& document, const Json& attributes, const std::string& name, std::uint64_t vertices) {
    const Json& colors = accessor_at(document, number(attributes, name.c_str(), none));
    const std::uint64_t count = number(colors, "count", 0);
    if (count != vertices) {
        refuse(name + " holds " + std::to_string(count) + " colours for " + std::to_string(vertices) + " vertices");
    }
    if (number(colors, "bufferView", none) == none && !colors.contains("sparse"))
        refuse(name + " has no buffer view: all its colours would be 0, a lock");
    const std::uint64_t type = number(colors, "componentType", 0);
    constexpr std::uint64_t unsigned_byte = 5121;
    constexpr std::uint64_t unsigned_short = 5123;
    const std::uint64_t channels = component_count(colors);
    if ((type != component_float && type != unsigned_byte && type != unsigned_short) ||
        (channels != 3 && channels != 4)) {
        refuse(name +
               " is not three or four floats, unsigned bytes or unsigned shorts; export colours as one of these");
    }
}

void check_colors(const Json& document, const Json& attributes, std::uint64_t vertices) {
    bool has_colors = false;
    std::string odd;
    for (const auto& [name, accessor] : attributes.items()) {
        if (is_color_set(name)) {
            check_color_set(document, attributes, name, vertices);
            has_colors = true;
        } else if (looks_like_color(name)) {
            odd = name;
        }
    }
    if (has_colors || odd.empty()) return;
    refuse("the attribute " + in_quotes(odd) +
           " looks like a colour, but only COLOR_0, COLOR_1 ... are read, and locks in it would be lost; rename it");
}

// assimp copies positions as floats whatever they are.
void check_attributes(const Json& document, const Json& attributes, Purpose purpose) {
    if (!attributes.is_object()) refuse("a primitive's attributes are not an object");
    const std::uint64_t position = number(attributes, "POSITION", none);
    if (position == none) return;
    const Json& positions = accessor_at(document, position);
    if (number(positions, "bufferView", none) == none && !positions.contains("sparse"))
        refuse("positions without a buffer are all 0: is the file compressed (Draco)? Export without compression");
    if (number(positions, "componentType", 0) != component_float || component_count(positions) != 3) {
        refuse("positions are not three floats (quantized?); export without compression");
    }
    if (purpose == Purpose::shell) check_colors(document, attributes, number(positions, "count", 0));
}

std::uint64_t triangles_of(const Json& document, const Json& primitive, Purpose purpose) {
    constexpr std::uint64_t triangles_mode = 4;  // below: points and lines; above: strips and fans
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end()) refuse("a primitive has no attributes");
    check_attributes(document, *attributes, purpose);
    if (primitive.contains("material") && number(primitive, "material", 0) >= list(document, "materials").size())
        refuse("a primitive has a material that is not there");
    const std::uint64_t mode = number(primitive, "mode", triangles_mode);
    constexpr std::uint64_t fan_mode = 6;
    if (mode > fan_mode) refuse("a primitive has the unknown mode " + std::to_string(mode));
    const std::uint64_t position = number(*attributes, "POSITION", none);
    const std::uint64_t indices = number(primitive, "indices", none);
    if (position == none || mode < triangles_mode) return 0;
    const std::uint64_t corners = number(accessor_at(document, indices == none ? position : indices), "count", 0);
    if (mode == triangles_mode && corners % 3 != 0)
        refuse("a primitive has " + std::to_string(corners) + " corners, which are no whole triangles");
    if (mode == triangles_mode) return corners / 3;
    return corners >= 3 ? corners - 2 : 0;
}

// By mesh.
std::vector<std::uint64_t> count_triangles(const Json& document, Purpose purpose) {
    std::vector<std::uint64_t> counts;
    for (const Json& mesh : list(document, "meshes")) {
        if (!mesh.is_object()) refuse("a mesh is not an object");
        counts.push_back(0);
        for (const Json& primitive : list(mesh, "primitives")) {
            if (!primitive.is_object()) refuse("a primitive is not an object");
            counts.back() += triangles_of(document, primitive, purpose);
        }
    }
    return counts;
}

// Nodes whose mesh joints would move.
std::uint64_t count_skinned(const Json& document) {
    std::uint64_t count = 0;
    for (const Json& node : list(document, "nodes")) count += node.contains("mesh") && node.contains("skin");
    return count;
}

// Meshes and nodes that mix in morph targets from the start.
std::uint64_t count_morphed(const Json& document) {
    std::uint64_t count = 0;
    for (const char* name : {"meshes", "nodes"}) {
        for (const Json& item : list(document, name)) {
            const Json& weights = list(item, "weights");
            count += std::any_of(weights.begin(), weights.end(),
                                 [](const Json& weight) { return weight.is_number() && weight.get<double>() != 0; });
        }
    }
    return count;
}

}

Prescan prescan_gltf(std::string_view bytes, Purpose purpose) {
    gltf::Document document = gltf::parse(bytes);
    const Json& json = document.json;
    Prescan result;
    check_version(json);
    result.extensions = gltf::check_extensions(json);
    const Json& buffers = list(json, "buffers");
    for (std::size_t i = 0; i < buffers.size(); ++i) check_buffer(document, buffers[i], i);
    const Json& views = list(json, "bufferViews");
    for (std::size_t i = 0; i < views.size(); ++i) check_view(json, views[i], i);
    const Json& accessors = list(json, "accessors");
    for (std::size_t i = 0; i < accessors.size(); ++i) check_accessor(json, accessors[i], i);
    for (const Json& node : list(json, "nodes")) result.transforms.push_back(transform_of(node));
    gltf::check_nodes(json);
    const std::vector<std::uint64_t> triangles = count_triangles(json, purpose);
    for (const Json& item : list(json, "materials")) {
        if (!item.is_object()) refuse("one of the materials is not an object");
    }
    result.buffers = gltf::external_buffers(json);
    for (const std::size_t mesh : gltf::choose_scene(document.json, result.unread))
        result.expected_triangles += triangles[mesh];
    result.unread.skins = count_skinned(json);
    result.unread.morphs = count_morphed(json);
    result.unread.bytes = document.unread;
    result.surface_only = gltf::surface_only(std::move(document), purpose == Purpose::shell);
    return result;
}

std::vector<ExternalBuffer> gltf_buffers(std::string_view bytes) {
    return gltf::external_buffers(gltf::parse(bytes).json);
}

}
