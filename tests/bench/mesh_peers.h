// SPDX-License-Identifier: GPL-3.0-or-later
// Other people's mesh generators, run on a shell as a person would from the command line.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/tet_mesh.h"

namespace crumple::bench {

// A shell as its file says it, to the digit: peers get what we import, not what we made of it.
struct RawShell {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
};

// The v and f lines of a Wavefront OBJ of triangles.
[[nodiscard]] RawShell read_raw_shell(const std::filesystem::path& path);

struct PeerMesh {
    TetMesh mesh;  // every tet turned to be positive, neighbours filled
    double cpu_s = 0;
};

// "tetgen", "hxt" (gmsh's, then Netgen's optimizer) or "gmsh" (its Delaunay), told to keep the shell's triangles and to
// make tets as large as its mean edge. Nothing when the program is not there, fails, or gives no mesh in ten minutes.
// Files are left in `folder`.
[[nodiscard]] std::optional<PeerMesh> run_peer(const std::string& peer, const RawShell& shell,
                                               const std::filesystem::path& folder);

}
