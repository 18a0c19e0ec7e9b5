// SPDX-License-Identifier: GPL-3.0-or-later
// Which tets of the convex hull lie in material. Sweeps move interior nodes only, so what is known of a tet of four
// shell vertices stays known; the others are asked anew each time. (Taking a tet for inside because one of its nodes is
// would let tets that bridge a concavity pull nodes out of the shell.)
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/context.h"
#include "core/index.h"
#include "mesh/tet_mesh.h"
#include "relax/material_space.h"

namespace crumple::relax {

class InsideTets {
public:
    explicit InsideTets(const MaterialSpace& space) : space_(space) {}

    // T: 1 where the tet's centre lies in material. spots: of the interior nodes, in their order.
    [[nodiscard]] std::vector<std::uint8_t> find(const TetMesh& mesh, std::span<const Spot> spots,
                                                 const Context& context);

private:
    using Corners = std::array<Index, 4>;  // ascending
    struct Known {
        Corners corners;
        std::uint8_t is_inside;
    };
    [[nodiscard]] const Known* look_up(const Corners& corners) const;
    void remember(const TetMesh& mesh, const std::vector<std::uint8_t>& is_inside);

    const MaterialSpace& space_;
    std::vector<Known> known_;  // ascending
};

}
