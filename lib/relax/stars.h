// SPDX-License-Identifier: GPL-3.0-or-later
// The tets around each interior node.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/index.h"
#include "mesh/tet_mesh.h"

namespace crumple::relax {

// N interior nodes.
struct Stars {
    std::vector<Index> start;            // N + 1
    std::vector<Index> tets;             // those inside, ascending; a node's are tets[start[n], start[n + 1])
    std::vector<std::uint8_t> is_whole;  // N: no tet at the node lies outside

    [[nodiscard]] std::span<const Index> of(std::size_t interior_node) const {
        return std::span(tets).subspan(start[interior_node], start[interior_node + 1] - start[interior_node]);
    }
};

[[nodiscard]] Stars find_stars(const TetMesh& mesh, std::span<const std::uint8_t> is_inside);

}
