// SPDX-License-Identifier: GPL-3.0-or-later
// Which tets the shell's surface passes through. Exact where it says no.
#pragma once
#include <array>

#include "core/vec3.h"
#include "geometry/bvh.h"
#include "geometry/triangle_contact.h"
#include "mesh/shell.h"

namespace crumple {

// False only when a plane proves that the triangle stays out of the open tet; touching its boundary is staying out.
[[nodiscard]] bool may_enter(const Corners& triangle, const std::array<Vec3, 4>& tet);

class TetClearance {
public:
    explicit TetClearance(const Shell& shell);

    // True when no shell triangle enters the positive tet: all of its inside lies on one side of every closed
    // component.
    [[nodiscard]] bool is_clear(const std::array<Vec3, 4>& tet) const;

private:
    std::vector<Corners> triangles_;
    Bvh tree_;
};

}
