// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_surface.h"

#include <initializer_list>
#include <utility>

namespace crumple::formats::gltf {

namespace {

// No URI is like it: a colon would be a scheme's.
std::string name_of_buffer(std::size_t index) { return "buffer:" + std::to_string(index); }

Json pick(Json& from, std::initializer_list<const char*> names) {
    Json picked = Json::object();
    for (const char* name : names) {
        if (const auto found = from.find(name); found != from.end()) picked[name] = std::move(*found);
    }
    return picked;
}

Json pick_each(Json& from, const char* list_name, std::initializer_list<const char*> names) {
    Json picked = Json::array();
    for (Json& item : from[list_name]) picked.push_back(pick(item, names));
    return picked;
}

Json surface_of(Json& primitive, bool has_colors) {
    Json picked = pick(primitive, {"indices", "mode", "material"});
    picked["attributes"] = Json::object();
    for (const auto& [name, accessor] : primitive["attributes"].items()) {
        if (name == "POSITION" || (has_colors && name.starts_with("COLOR_"))) picked["attributes"][name] = accessor;
    }
    return picked;
}

Json meshes_of(Json& json, bool has_colors) {
    Json picked = Json::array();
    for (Json& mesh : json["meshes"]) {
        Json surface = pick(mesh, {"name"});
        surface["primitives"] = Json::array();
        for (Json& primitive : mesh["primitives"]) surface["primitives"].push_back(surface_of(primitive, has_colors));
        picked.push_back(std::move(surface));
    }
    return picked;
}

Json accessors_of(Json& json) {
    Json picked = Json::array();
    for (Json& accessor : json["accessors"]) {
        Json kept = pick(accessor, {"bufferView", "byteOffset", "componentType", "count", "type", "normalized"});
        if (accessor.contains("sparse")) {
            Json& sparse = accessor["sparse"];
            kept["sparse"] = pick(sparse, {"count"});
            kept["sparse"]["indices"] = pick(sparse["indices"], {"bufferView", "byteOffset", "componentType"});
            kept["sparse"]["values"] = pick(sparse["values"], {"bufferView", "byteOffset"});
        }
        picked.push_back(std::move(kept));
    }
    return picked;
}

Json buffers_of(Json& json) {
    Json picked = pick_each(json, "buffers", {"byteLength", "uri"});
    for (std::size_t i = 0; i < picked.size(); ++i) {
        if (const std::string uri = uri_of(picked[i]); !uri.empty() && !is_data(uri))
            picked[i]["uri"] = name_of_buffer(i);
    }
    return picked;
}

}

std::vector<ExternalBuffer> external_buffers(const Json& json) {
    std::vector<ExternalBuffer> external;
    const Json& buffers = list(json, "buffers");
    const std::vector<bool> used = used_buffers(json);
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::string uri = uri_of(buffers[i]);
        if (!used[i] || uri.empty() || is_data(uri)) continue;
        external.push_back({uri, name_of_buffer(i), number(buffers[i], "byteLength", 0)});
    }
    return external;
}

std::string surface_only(Document document, bool has_colors) {
    Json& from = document.json;
    // assimp takes the first buffer of a binary file for its chunk, even where it says another file.
    const Json& buffers = list(from, "buffers");
    const bool has_chunk = document.is_binary && !buffers.empty() && uri_of(buffers[0]).empty();
    Json to = pick(from, {"scene"});
    to["asset"] = pick(from["asset"], {"version", "generator"});
    const auto keep = [&](const char* name, auto&& what) {
        if (from.contains(name)) to[name] = what();
    };
    const auto keep_each = [&](const char* name, std::initializer_list<const char*> members) {
        keep(name, [&] { return pick_each(from, name, members); });
    };
    keep_each("scenes", {"name", "nodes"});
    keep_each("nodes", {"name", "children", "mesh", "matrix", "translation", "rotation", "scale"});
    keep("meshes", [&] { return meshes_of(from, has_colors); });
    keep_each("materials", {"name"});
    keep("accessors", [&] { return accessors_of(from); });
    keep_each("bufferViews", {"buffer", "byteOffset", "byteLength", "byteStride", "target"});
    keep("buffers", [&] { return buffers_of(from); });
    std::string text = to.dump();
    return has_chunk ? binary_file(std::move(text), document.binary) : text;
}

}
