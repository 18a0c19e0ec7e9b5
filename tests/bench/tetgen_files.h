// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>

#include "mesh/tet_mesh.h"

namespace crumple::bench {

// Nodes and elements of TetGen's <name>.1.node and <name>.1.ele, which number from `first`; as they stand there, of
// either orientation. Short or missing files give a short or empty mesh.
[[nodiscard]] TetMesh read_tetgen(const std::filesystem::path& folder, const std::string& name, Index first);

}
