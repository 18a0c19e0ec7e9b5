// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_document.h"

#include <cstring>

#include "core/error.h"

namespace crumple::formats::gltf {

namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::bad_input, what); }

constexpr std::uint32_t magic = 0x46546c67;         // "glTF"
constexpr std::uint32_t json_chunk = 0x4e4f534a;    // "JSON"
constexpr std::uint32_t binary_chunk = 0x004e4942;  // "BIN"
constexpr std::size_t header_size = 12;
constexpr std::size_t chunk_header_size = 8;

std::uint32_t u32_at(std::string_view bytes, std::size_t offset) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

void append(std::string& bytes, std::size_t number) {
    const auto value = static_cast<std::uint32_t>(number);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void check_header(std::string_view bytes) {
    if (bytes.size() < header_size + chunk_header_size) refuse("the file ends within its header");
    if (u32_at(bytes, 4) != 2)
        refuse("glTF version " + std::to_string(u32_at(bytes, 4)) + " is not read; export glTF 2.0");
    const std::size_t length = u32_at(bytes, 8);
    if (length > bytes.size() || length < header_size + chunk_header_size) {
        refuse("the header announces " + std::to_string(length) + " bytes, the file has " +
               std::to_string(bytes.size()));
    }
}

// The chunk at the start of the bytes, which are moved behind it.
std::string_view take_chunk(std::string_view& bytes, std::uint32_t type, const char* what) {
    const std::size_t size = u32_at(bytes, 0);
    if (u32_at(bytes, 4) != type) refuse(std::string("the chunk of ") + what + " is missing");
    if (size > bytes.size() - chunk_header_size)
        refuse(std::string("the ") + what + " chunk is longer than the file, or than its header announces");
    const std::string_view chunk = bytes.substr(chunk_header_size, size);
    bytes.remove_prefix(chunk_header_size + size);
    return chunk;
}

// What goes over a document calls itself for each level.
void check_depth(std::string_view text) {
    constexpr int deepest = 100;
    int depth = 0;
    bool is_quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') is_quoted = !is_quoted;
        if (is_quoted && c == '\\') ++i;
        if (is_quoted) continue;
        if ((c == '[' || c == '{') && ++depth > deepest)
            refuse("the JSON is nested more than " + std::to_string(deepest) + " deep");
        if (c == ']' || c == '}') --depth;
    }
}

Json parse_json(std::string_view text) {
    check_depth(text);
    Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) refuse("it is no glTF, or the JSON in it is damaged");
    return json;
}

}

Document parse(std::string_view bytes) {
    if (bytes.size() < sizeof magic || u32_at(bytes, 0) != magic) return {parse_json(bytes), false, {}, 0};
    check_header(bytes);
    const std::size_t length = u32_at(bytes, 8);
    std::string_view left = bytes.substr(header_size, length - header_size);
    Document document{parse_json(take_chunk(left, json_chunk, "JSON")), true, {}, bytes.size() - length};
    // Chunks of other kinds may follow, or none at all.
    if (left.size() >= chunk_header_size && u32_at(left, 4) == binary_chunk)
        document.binary = take_chunk(left, binary_chunk, "BIN");
    return document;
}

std::string binary_file(std::string json, std::string_view binary) {
    json.append((4 - json.size() % 4) % 4, ' ');
    const std::size_t padding = (4 - binary.size() % 4) % 4;
    std::string bytes;
    append(bytes, magic);
    append(bytes, 2);
    append(bytes, header_size + 2 * chunk_header_size + json.size() + binary.size() + padding);
    append(bytes, json.size());
    append(bytes, json_chunk);
    bytes += json;
    append(bytes, binary.size() + padding);
    append(bytes, binary_chunk);
    bytes += binary;
    bytes.append(padding, '\0');
    return bytes;
}

const Json& list(const Json& object, const char* name) {
    static const Json empty = Json::array();
    const auto found = object.find(name);
    if (found == object.end()) return empty;
    if (!found->is_array()) refuse(std::string(name) + " is not a list");
    return *found;
}

std::uint64_t number(const Json& object, const char* name, std::uint64_t absent) {
    if (!object.is_object()) refuse(std::string("an object with '") + name + "' was expected");
    const auto found = object.find(name);
    if (found == object.end()) return absent;
    constexpr std::uint64_t most = std::uint64_t{1} << 48;  // sums and products of these stay in 64 bits
    if (!found->is_number_unsigned() || found->get<std::uint64_t>() > most)
        refuse(std::string(name) + " is not a size");
    return found->get<std::uint64_t>();
}

std::string uri_of(const Json& buffer) {
    if (!buffer.is_object()) refuse("a buffer is not an object");
    const auto uri = buffer.find("uri");
    if (uri == buffer.end()) return {};
    if (!uri->is_string()) refuse("the uri of a buffer is no text");
    return uri->get<std::string>();
}

std::vector<bool> used_buffers(const Json& json) {
    const Json& accessors = list(json, "accessors");
    const Json& views = list(json, "bufferViews");
    std::vector<bool> used(list(json, "buffers").size(), false);
    const auto use_view = [&](std::uint64_t view) {
        if (view >= views.size()) return;
        const std::uint64_t buffer = number(views[view], "buffer", none);
        if (buffer < used.size()) used[buffer] = true;
    };
    const auto use = [&](std::uint64_t index) {
        if (index >= accessors.size()) return;
        use_view(number(accessors[index], "bufferView", none));
        const auto sparse = accessors[index].find("sparse");
        if (sparse == accessors[index].end() || !sparse->is_object()) return;
        for (const char* part : {"indices", "values"}) {
            if (sparse->contains(part)) use_view(number((*sparse)[part], "bufferView", none));
        }
    };
    for (const Json& mesh : list(json, "meshes")) {
        for (const Json& primitive : list(mesh, "primitives")) for_each_accessor(primitive, use);
    }
    return used;
}

}
