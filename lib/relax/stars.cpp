// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/stars.h"

namespace crumple::relax {

Stars find_stars(const TetMesh& mesh, std::span<const std::uint8_t> is_inside) {
    const Index first = mesh.shell_vertex_count;
    const std::size_t node_count = mesh.positions.size() - first;
    Stars stars{std::vector<Index>(node_count + 1), {}, std::vector<std::uint8_t>(node_count, 1)};
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        for (const Index node : mesh.tets[t]) {
            if (node < first) continue;
            if (is_inside[t]) {
                ++stars.start[node - first + 1];
            } else {
                stars.is_whole[node - first] = 0;
            }
        }
    }
    for (std::size_t n = 0; n < node_count; ++n) stars.start[n + 1] += stars.start[n];
    stars.tets.resize(stars.start.back());
    std::vector<Index> next(stars.start.begin(), stars.start.end() - 1);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        if (!is_inside[t]) continue;
        for (const Index node : mesh.tets[t]) {
            if (node >= first) stars.tets[next[node - first]++] = static_cast<Index>(t);
        }
    }
    return stars;
}

}
