// SPDX-License-Identifier: GPL-3.0-or-later
// What a file says about its unit and axes, taken out of assimp's scene.
#pragma once
#include "formats/format.h"
#include "importer/scene.h"

struct aiScene;

namespace crumple::importer {

// Fills unit, up and axes of scene, and frees its root node from what assimp put there for them (COLLADA).
// Throws Error(bad_input) for an FBX file whose axes are none.
void read_file_space(const aiScene& from, formats::FormatId format, Scene& scene);

}
