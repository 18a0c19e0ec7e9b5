// SPDX-License-Identifier: GPL-3.0-or-later
// A glTF 2.0 file taken apart: its JSON, and the binary chunk of a .glb. For the few files of this folder that look
// into the JSON; others know it by what they find there.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "core/index.h"

namespace crumple::formats::gltf {

using Json = nlohmann::json;

struct Document {
    Json json;                // an object
    bool is_binary = false;   // .glb
    std::string_view binary;  // its second chunk, into the bytes given
    std::size_t unread = 0;   // bytes behind the length that its header says
};

// The container fits the bytes and the JSON is well formed. Throws Error(bad_input).
[[nodiscard]] Document parse(std::string_view bytes);

// The container around JSON and binary chunk again.
[[nodiscard]] std::string binary_file(std::string json, std::string_view binary);

// A member that is a list, empty where it is absent. Throws Error(bad_input) where it is something else.
[[nodiscard]] const Json& list(const Json& object, const char* name);

// A member that is a non-negative whole number, or the value given where it is absent.
[[nodiscard]] std::uint64_t number(const Json& object, const char* name, std::uint64_t absent);

// The URI of a buffer; empty: it has none. Throws Error(bad_input) for one that is no text.
[[nodiscard]] std::string uri_of(const Json& buffer);

// "data:...", the content itself.
[[nodiscard]] inline bool is_data(std::string_view uri) { return uri.starts_with("data:"); }

// By buffer: whether a triangle's position, colour or index comes from it.
[[nodiscard]] std::vector<bool> used_buffers(const Json& json);

// Calls visit(accessor) for the accessors of a primitive that say where its surface is and how it is painted.
template <class Visit>
void for_each_accessor(const Json& primitive, Visit&& visit) {
    visit(number(primitive, "indices", none));
    const auto attributes = primitive.find("attributes");
    if (attributes == primitive.end() || !attributes->is_object()) return;
    for (const auto& [name, accessor] : attributes->items()) {
        if (name == "POSITION" || name.starts_with("COLOR_")) visit(number(*attributes, name.c_str(), none));
    }
}

}
