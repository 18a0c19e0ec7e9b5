// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/load_scene.h"

#include <vector>

#include "core/error.h"
#include "core/names.h"
#include "report/json_reader.h"
#include "report/json_schema.h"
#include "store/read_file.h"

namespace crumple::study {
namespace {

constexpr std::size_t max_scene_bytes = 1u << 20;

}

Scene read_scene(std::string_view json, std::string_view source) {
    Scene scene;
    report::read_json(json, source, report::Described::of(scene), {.max_bytes = max_scene_bytes});
    try {
        check_params(scene);
    } catch (const Error& error) {
        throw Error(error.kind(), std::string(source) + ": " + error.what());
    }
    return scene;
}

Scene load_scene(const std::string& name_or_path) {
    if (name_or_path.ends_with(".json") || name_or_path.find('/') != std::string::npos) {
        const std::vector<std::byte> bytes = store::read_file(name_or_path);
        return read_scene({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name_or_path);
    }
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtin_scenes()) {
        if (scene.name == name_or_path) return read_scene(scene.json, name_or_path);
        names.emplace_back(scene.name);
    }
    throw Error(ErrorKind::usage, "no scene '" + name_or_path + "'; nearest: '" + nearest_name(name_or_path, names) +
                                      "' (there are: " + list_names(names) + "; or give the path of a .json file)");
}

std::string scene_schema() {
    Scene scene;
    return report::write_schema(report::Described::of(scene),
                                {"scene", "A scene of crumple simulate", "What happens to a bundle."},
                                report::SchemaUse::input);
}

}
