// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

namespace crumple::formats {

// What of a file is not read, and nobody is told otherwise.
struct Unread {
    std::uint64_t bytes = 0;              // behind what its header announces (PLY, binary glTF)
    std::uint64_t free_form = 0;          // curves and surfaces that are not polygons (OBJ)
    std::uint64_t points_and_lines = 0;   // OBJ; of other formats assimp counts them
    std::uint64_t colored_faces = 0;      // with a colour of their own (PLY, OFF, FBX)
    std::uint64_t polypaint = 0;          // vertices with a colour in comments of ZBrush (OBJ)
    std::uint64_t nodes = 0;              // with a mesh, outside the scene that is read (glTF)
    std::uint64_t nodes_of_no_scene = 0;  // read although no scene says so (glTF)
    std::uint64_t skins = 0;              // nodes whose mesh joints would move (glTF)
    std::uint64_t morphs = 0;             // meshes and nodes that mix in morph targets from the start (glTF)
};

}
