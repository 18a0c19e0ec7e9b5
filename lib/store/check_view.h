// SPDX-License-Identifier: MIT
// The view that ParaView opens must show what the bundle says, or a person looks at one mesh and plays with another.
#pragma once
#include <string>
#include <vector>

#include "bundle/bundle.h"
#include "store/hdf5_file.h"

namespace crumple::store {

// Paths under /VTKHDF that do not agree with the bundle; empty also where there is no view. Arrays that were added for
// looking at (in PointData and CellData) need a row a node or a tet. Throws Error(bad_input) for a view that lacks an
// array.
[[nodiscard]] std::vector<std::string> find_view_differences(const FileReader& file, const Bundle& bundle);

}
