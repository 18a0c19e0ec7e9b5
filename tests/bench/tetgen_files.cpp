// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/tetgen_files.h"

#include <fstream>

namespace crumple::bench {

TetMesh read_tetgen(const std::filesystem::path& folder, const std::string& name, Index first) {
    TetMesh mesh;
    std::ifstream nodes(folder / (name + ".1.node"));
    std::size_t count = 0;
    int ignored = 0;
    nodes >> count >> ignored >> ignored >> ignored;
    for (std::size_t v = 0; nodes && v < count; ++v) {
        Vec3 p;
        nodes >> ignored >> p.x >> p.y >> p.z;
        mesh.positions.push_back(p);
    }
    std::ifstream tets(folder / (name + ".1.ele"));
    count = 0;
    tets >> count >> ignored >> ignored;
    for (std::size_t t = 0; tets && t < count; ++t) {
        Tet tet{};
        tets >> ignored;
        for (Index& node : tet) {
            tets >> node;
            node -= first;
        }
        mesh.tets.push_back(tet);
    }
    return mesh;
}

}
