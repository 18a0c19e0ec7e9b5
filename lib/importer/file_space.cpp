// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/file_space.h"

#include <assimp/scene.h>

#include <charconv>
#include <cmath>
#include <system_error>

#include "core/error.h"

namespace crumple::importer {

namespace {

// assimp holds units as float; the file's decimal is the shortest that rounds to it (0.0254, not 0.02539999969).
double shortest_decimal(float value) {
    char text[32];
    const auto [end, error] = std::to_chars(text, text + sizeof text, value);
    double result = value;
    if (error == std::errc{}) std::from_chars(text, end, result);
    return result;
}

template <class T>
T metadata(const aiScene& scene, const char* key, T otherwise) {
    T value{};
    return scene.mMetaData && scene.mMetaData->Get(key, value) ? value : otherwise;
}

// FBX counts in centimetres times UnitScaleFactor, and names which of its axes (0, 1, 2) point up, to the front, right.
void read_fbx_space(const aiScene& from, Scene& scene) {
    double factor = metadata<float>(from, "UnitScaleFactor", 1.0f);
    factor = metadata<double>(from, "UnitScaleFactor", shortest_decimal(static_cast<float>(factor)));
    if (factor > 0 && std::isfinite(factor)) scene.unit = factor * 0.01;

    const int axis[3] = {metadata(from, "CoordAxis", 0), metadata(from, "UpAxis", 1), metadata(from, "FrontAxis", 2)};
    const int sign[3] = {metadata(from, "CoordAxisSign", 1), metadata(from, "UpAxisSign", 1),
                         metadata(from, "FrontAxisSign", 1)};
    bool used[3] = {};
    scene.axes = {};
    for (int row = 0; row < 3; ++row) {
        if (axis[row] < 0 || axis[row] > 2 || used[axis[row]]) {
            throw Error(ErrorKind::bad_input, "GlobalSettings names axes that are none, or one of them twice");
        }
        used[axis[row]] = true;
        scene.axes[static_cast<std::size_t>(3 * row + axis[row])] = sign[row] < 0 ? -1 : 1;
    }
    scene.up = axis[1] == 0 ? Up::x : axis[1] == 1 ? Up::y : Up::z;
}

// assimp multiplies COLLADA's unit and axes into the root node: unit * axes_of(up), which is taken out again.
void read_dae_space(Scene& scene) {
    auto& root = scene.nodes.front().transform;
    if (root[3] != 0 || root[7] != 0 || root[11] != 0) return;
    for (const Up up : {Up::y, Up::x, Up::z}) {
        const auto axes = axes_of(up);
        float unit = 0;
        for (std::size_t i = 0; i < 3; ++i) unit = std::fmax(unit, static_cast<float>(std::fabs(root[i])));
        bool matches = unit > 0;
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 3; ++column) {
                matches = matches && root[4 * row + column] == axes[3 * row + column] * unit;
            }
        }
        if (!matches) continue;
        scene.unit = shortest_decimal(unit);
        scene.up = up;
        scene.axes = axes;
        root = SceneNode{}.transform;
        return;
    }
}

}

void read_file_space(const aiScene& from, formats::FormatId format, Scene& scene) {
    if (format == formats::FormatId::fbx) read_fbx_space(from, scene);
    if (format == formats::FormatId::dae) read_dae_space(scene);
    if (format == formats::FormatId::gltf) {
        scene.unit = 1;
        scene.up = Up::y;
    }
}

}
