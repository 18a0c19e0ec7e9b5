// SPDX-License-Identifier: GPL-3.0-or-later
// The files that import reads: those it is given, and the buffers that a glTF file keeps in others. Nothing else is
// opened: an OBJ's material library, textures and the like do not change what comes out.
#pragma once
#include <string>
#include <vector>

#include "importer/import.h"

namespace crumple::importer {

struct InputFile {
    std::string name;  // "shell", "visual/<name>", and "<that>/buffer/<n>": where it lies is not part of it
    std::string path;
    std::string owner;  // path of the glTF file it belongs to, empty: it was given
};

// Each file given with what belongs to it, in order, whether it is there or not. A file that cannot be read as glTF has
// nothing that belongs to it: import says what is wrong with it. Throws Error(usage) as visual_names does,
// Error(budget) when the system leaves too little memory to look. REQUIRES: as import_asset.
[[nodiscard]] std::vector<InputFile> input_files(const Sources& sources, const Params& params = {});

// As far as can be told without assimp: that each file is there, is of a format that is read, and what its prescan asks
// (prescan.h; nothing of STL and of X that is not text). Throws as import_asset. REQUIRES: as import_asset.
void look_at_inputs(const Sources& sources, const Params& params = {});

// Where a URI of a glTF file leads to. Throws Error(bad_input) for what is no relative path. May look whether a file is
// there: exporters that do not encode '%' are forgiven.
[[nodiscard]] std::string path_of_uri(const std::string& gltf_path, const std::string& uri);

}
