// SPDX-License-Identifier: MIT
#include "store/export_msh.h"

#include <algorithm>

#include "store/text_file.h"

namespace crumple::store {
namespace {

// gmsh's element types.
constexpr int msh_point = 15;
constexpr int msh_tet = 4;

// A name goes between quotes on one line.
std::string quotable(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '"' || static_cast<unsigned char>(c) < 0x20; }, '_');
    return name;
}

}

std::string export_msh(const Bundle& b) {
    const std::size_t locked_tag = b.regions.size() + 1;
    const auto locked_count = static_cast<std::size_t>(std::count(b.locked.begin(), b.locked.end(), 1));
    TextFile out;
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n" << b.regions.size() + 1 << '\n';
    for (std::size_t region = 0; region < b.regions.size(); ++region)
        out << "3 " << region + 1 << " \"" << quotable(b.regions[region]) << "\"\n";
    out << "0 " << locked_tag << " \"locked\"\n$EndPhysicalNames\n$Nodes\n" << b.rest_positions.size() << '\n';
    for (std::size_t node = 0; node < b.rest_positions.size(); ++node)
        out << node + 1 << ' ' << b.rest_positions[node] << '\n';
    out << "$EndNodes\n$Elements\n" << locked_count + b.tets.size() << '\n';
    std::size_t element = 0;
    for (std::size_t node = 0; node < b.locked.size(); ++node) {
        if (b.locked[node])
            out << ++element << ' ' << msh_point << " 2 " << locked_tag << ' ' << locked_tag << ' ' << node + 1 << '\n';
    }
    for (std::size_t t = 0; t < b.tets.size(); ++t) {
        out << ++element << ' ' << msh_tet << " 2 " << b.region[t] + 1 << ' ' << b.region[t] + 1;
        for (const Index node : b.tets[t]) out << ' ' << std::size_t{node} + 1;
        out << '\n';
    }
    out << "$EndElements\n";
    return out.take();
}

}
