// SPDX-License-Identifier: GPL-3.0-or-later
// Where a tet can be added to a mesh without running into what is there.
#pragma once
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"
#include "geometry/bvh.h"

namespace crumple::finish {

class OpenSpace {
public:
    // faces: the surface of the tets, which stays alive as long as this.
    OpenSpace(std::span<const Vec3> positions, std::span<const Triangle> faces);

    // positions: as given before, perhaps with more behind. True when exact planes prove that no face enters the tet,
    // that none of `others` overlaps it, and it is positive. REQUIRES: a tet that has an exposed face on the side where
    // no tet is, so that it cannot lie inside the mesh.
    [[nodiscard]] bool has_room_for(std::span<const Vec3> positions, const Tet& tet, std::span<const Tet> others) const;

private:
    std::span<const Triangle> faces_;
    Bvh tree_;
};

}
