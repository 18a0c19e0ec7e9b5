// SPDX-License-Identifier: GPL-3.0-or-later
// The file formats import reads, known by extension, and what each is like.
#pragma once
#include <string>
#include <string_view>

namespace crumple::formats {

enum class FormatId { obj, ply, off, stl, gltf, dae, fbx, x };

struct Format {
    FormatId id;
    std::string_view extension;    // lower case, without the dot
    std::string_view name;         // for people
    std::string_view assimp_name;  // what assimp calls the importer it must have used
    bool may_hold_byte_colors;     // whole numbers 0..255 arrive unscaled
};

// By the extension of path, in any case. Throws Error(bad_input) naming the formats that work.
[[nodiscard]] const Format& format_of(const std::string& path);

}
