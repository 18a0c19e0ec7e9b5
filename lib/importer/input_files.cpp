// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/input_files.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "core/error.h"
#include "formats/disguise.h"
#include "formats/format.h"
#include "formats/prescan.h"
#include "formats/printable.h"
#include "importer/read_scene.h"
#include "importer/source_file.h"
#include "sandbox/sandbox.h"

namespace crumple::importer {

namespace {

namespace fs = std::filesystem;

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

// RFC 3986, section 2.1; a '%' without two digits stands for itself.
std::string percent_decoded(const std::string& uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool is_code =
            uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0;
        text += is_code ? static_cast<char>(16 * hex_digit(uri[i + 1]) + hex_digit(uri[i + 2])) : uri[i];
        if (is_code) i += 2;
    }
    return text;
}

// "http:", "file:", "C:".
bool has_scheme(const std::string& uri) {
    const std::size_t colon = uri.find(':');
    return colon != std::string::npos && uri.find('/') > colon;
}

// Paths, each with a zero behind it: no path holds one.
std::vector<std::byte> encoded(const std::vector<std::string>& paths) {
    std::vector<std::byte> bytes;
    for (const std::string& path : paths) {
        const auto* begin = reinterpret_cast<const std::byte*>(path.c_str());
        bytes.insert(bytes.end(), begin, begin + path.size() + 1);
    }
    return bytes;
}

std::vector<std::string> decoded(const std::vector<std::byte>& bytes) {
    std::vector<std::string> paths;
    for (auto begin = bytes.begin(); begin != bytes.end();) {
        const auto end = std::find(begin, bytes.end(), std::byte{0});
        paths.emplace_back(reinterpret_cast<const char*>(&*begin), static_cast<std::size_t>(end - begin));
        begin = end == bytes.end() ? end : end + 1;
    }
    return paths;
}

std::vector<std::string> read_buffer_paths(const std::string& path) {
    std::vector<std::string> paths;
    std::string bytes = read_file(path);
    formats::undisguise(bytes, formats::FormatId::gltf);
    for (const formats::ExternalBuffer& buffer : formats::gltf_buffers(bytes))
        paths.push_back(path_of_uri(path, buffer.uri));
    return paths;
}

bool is_gltf(const std::string& path) {
    try {
        return formats::format_of(path).id == formats::FormatId::gltf;
    } catch (const Error&) {
        return false;
    }
}

std::vector<std::string> buffer_paths(const std::string& path, const Params& params) {
    if (!is_gltf(path)) return {};
    const auto outcome = sandbox::run_in_child([&] { return encoded(read_buffer_paths(path)); }, limits_of(params));
    if (outcome.ending == sandbox::Ending::starved) throw Error(ErrorKind::budget, path + ": " + outcome.message);
    return outcome.ending == sandbox::Ending::ok ? decoded(outcome.answer) : std::vector<std::string>();
}

void add_file(const std::string& name, const std::string& path, const Params& params, std::vector<InputFile>& files) {
    files.push_back({name, path, ""});
    const std::vector<std::string> buffers = buffer_paths(path, params);
    for (std::size_t i = 0; i < buffers.size(); ++i)
        files.push_back({name + "/buffer/" + std::to_string(i), buffers[i], path});
}

}

std::string path_of_uri(const std::string& gltf_path, const std::string& uri) {
    const std::string name = percent_decoded(uri);
    if (has_scheme(uri) || name.starts_with("/") || name.find('\0') != std::string::npos) {
        throw Error(ErrorKind::bad_input, "its buffer " + formats::in_quotes(uri) +
                                              " is not named by a path relative to the file; keep them in one folder, "
                                              "or export .glb");
    }
    const fs::path folder = fs::path(gltf_path).parent_path();
    std::error_code ignored;
    const bool is_literal = !fs::exists(folder / name, ignored) && fs::exists(folder / uri, ignored);
    return (folder / (is_literal ? uri : name)).string();
}

std::vector<InputFile> input_files(const Sources& sources, const Params& params) {
    const std::vector<std::string> names = visual_names(sources);
    std::vector<InputFile> files;
    add_file("shell", sources.shell, params, files);
    for (std::size_t i = 0; i < names.size(); ++i)
        add_file("visual/" + names[i], sources.visuals[i].path, params, files);
    return files;
}

void look_at_inputs(const Sources& sources, const Params& params) {
    look_at_file(sources.shell, formats::Purpose::shell, params);
    for (const Sources::Visual& visual : sources.visuals) look_at_file(visual.path, formats::Purpose::visual, params);
}

}
