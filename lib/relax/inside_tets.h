// SPDX-License-Identifier: GPL-3.0-or-later
// Which tets of the convex hull lie in material. Sweeps move interior nodes only, so what is known of a tet of four
// shell vertices stays known; the others are asked anew each time. (Taking a tet for inside because one of its nodes is
// would let tets that bridge a concavity pull nodes out of the shell.)
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "core/index.h"
#include "mesh/shell_interior.h"
#include "mesh/tet_mesh.h"

namespace crumple::relax {

class InsideTets {
public:
    explicit InsideTets(const ShellInterior& interior) : interior_(interior) {}

    // T: 1 where the tet's centre lies in material.
    [[nodiscard]] std::vector<std::uint8_t> find(const TetMesh& mesh, const Context& context);

private:
    using Corners = std::array<Index, 4>;  // ascending
    struct Known {
        Corners corners;
        std::uint8_t is_inside;
    };
    [[nodiscard]] const Known* look_up(const Corners& corners) const;
    void remember(const TetMesh& mesh, const std::vector<std::uint8_t>& is_inside);

    const ShellInterior& interior_;
    std::vector<Known> known_;  // ascending
};

}
