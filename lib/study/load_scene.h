// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes by name or path, as strict JSON.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "study/scene.h"

namespace crumple::study {

struct BuiltinScene {
    std::string_view name;
    std::string_view json;
};
[[nodiscard]] std::span<const BuiltinScene> builtin_scenes();

// A name is one of the scenes inside the program, anything with a slash or ending in .json a file. Throws Error(usage)
// with the path of the key, Error(file) when it cannot be read.
[[nodiscard]] Scene load_scene(const std::string& name_or_path);
[[nodiscard]] Scene read_scene(std::string_view json, std::string_view source);
[[nodiscard]] std::string scene_schema();

}
