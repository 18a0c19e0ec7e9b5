// SPDX-License-Identifier: MIT
// The faces of a bundle that belong to one tet only.
#pragma once
#include <vector>

#include "bundle/bundle.h"

namespace crumple::store {

// Counter-clockwise from outside, in the order of their tets.
[[nodiscard]] std::vector<Triangle> boundary_faces(const Bundle& bundle);

}
