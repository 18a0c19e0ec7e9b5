// SPDX-License-Identifier: MIT
// The tets in gmsh's MSH 2.2 text format.
#pragma once
#include <string>

#include "bundle/bundle.h"

namespace crumple::store {

// Physical groups: one volume a region (tag region + 1), and "locked" (points, tag one more than the regions have).
// Numbers read back exactly.
[[nodiscard]] std::string export_msh(const Bundle& bundle);

}
