// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/format.h"

#include <algorithm>
#include <filesystem>

#include "core/error.h"

namespace crumple::formats {

namespace {

// assimp reads more, but loses colours (glTF 1), crashes (3MF) or was never tried with locks (the rest).
constexpr Format formats[] = {
    {FormatId::obj, "obj", "Wavefront OBJ", "Wavefront Object Importer", true},
    {FormatId::ply, "ply", "Stanford PLY", "Stanford Polygon Library (PLY) Importer", false},
    {FormatId::off, "off", "OFF", "OFF Importer", true},
    {FormatId::stl, "stl", "STL", "Stereolithography (STL) Importer", false},
    {FormatId::gltf, "gltf", "glTF 2.0", "glTF2 Importer", false},
    {FormatId::gltf, "glb", "binary glTF 2.0", "glTF2 Importer", false},
    {FormatId::dae, "dae", "COLLADA", "Collada Importer", false},
    {FormatId::fbx, "fbx", "Autodesk FBX", "Autodesk FBX Importer", false},
    {FormatId::x, "x", "DirectX X", "Direct3D XFile Importer", false},
};

std::string known_extensions() {
    std::string list;
    for (const Format& format : formats) list.append(list.empty() ? "." : ", .").append(format.extension);
    return list;
}

}

const Format& format_of(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    for (const Format& format : formats) {
        if (extension.size() > 1 && std::string_view(extension).substr(1) == format.extension) return format;
    }
    const std::string what = extension.empty() ? "a file without extension is" : extension + " files are";
    throw Error(ErrorKind::bad_input, path + ": " + what + " not read; export as one of " + known_extensions());
}

}
