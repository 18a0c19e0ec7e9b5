// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/gltf_extensions.h"

#include <algorithm>
#include <string_view>

#include "core/error.h"
#include "formats/printable.h"

namespace crumple::formats::gltf {

namespace {

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::bad_input, what); }

// What they begin with: extensions about light, looks, levels of detail, sound, physics and notes. What does not know
// them still sees the same surface [the registry of extensions, KhronosGroup/glTF].
constexpr std::string_view harmless[] = {"KHR_materials_",
                                         "KHR_texture_",
                                         "KHR_lights_",
                                         "KHR_animation_",
                                         "KHR_xmp",
                                         "KHR_node_",
                                         "KHR_audio",
                                         "KHR_techniques_",
                                         "KHR_physics_",
                                         "KHR_collision_",
                                         "EXT_texture_",
                                         "EXT_lights_",
                                         "EXT_mesh_features",
                                         "EXT_mesh_manifold",
                                         "EXT_instance_features",
                                         "EXT_structural_metadata",
                                         "EXT_feature_metadata",
                                         "ADOBE_materials_",
                                         "AGI_",
                                         "CESIUM_primitive_outline",
                                         "FB_geometry_metadata",
                                         "GRIFFEL_bim_data",
                                         "MSFT_lod",
                                         "MSFT_packing_",
                                         "MSFT_texture_",
                                         "MSFT_audio",
                                         "MSFT_physics",
                                         "MSFT_collision",
                                         "NV_materials_",
                                         "OMI_",
                                         "VRM",
                                         "XMP"};

constexpr std::string_view compressions[] = {"KHR_draco_mesh_compression", "KHR_mesh_quantization",
                                             "EXT_meshopt_compression", "KHR_meshopt_compression"};

bool is_harmless(const std::string& name) {
    return std::any_of(std::begin(harmless), std::end(harmless),
                       [&](std::string_view start) { return name.starts_with(start); });
}

[[noreturn]] void refuse_extension(const std::string& name) {
    if (std::find(std::begin(compressions), std::end(compressions), name) != std::end(compressions))
        refuse("its geometry is compressed (" + in_quotes(name) + "), which is not read; export without compression");
    refuse("it needs the extension " + in_quotes(name) + ", which is not read; export without it");
}

}

std::vector<std::string> check_extensions(const Json& document) {
    std::vector<std::string> ignored;
    for (const Json& item : list(document, "extensionsRequired")) {
        if (!item.is_string()) refuse("the name of a required extension is no text");
        const std::string name = item.get<std::string>();
        if (!is_harmless(name)) refuse_extension(name);
        ignored.push_back(name);
    }
    for (const Json& node : list(document, "nodes")) {
        if (node.contains("extensions") && node["extensions"].contains("EXT_mesh_gpu_instancing"))
            refuse("a node is drawn many times (EXT_mesh_gpu_instancing), which is not read; export copies instead");
    }
    return ignored;
}

}
