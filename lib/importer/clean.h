// SPDX-License-Identifier: GPL-3.0-or-later
// Takes out what is in a file but not in a surface: triangles without area, second copies, vertices nobody uses.
#pragma once
#include <cstdint>
#include <vector>

#include "core/finding.h"
#include "importer/surface.h"
#include "importer/weld.h"

namespace crumple::importer {

struct Cleaned {
    std::uint64_t repeated_index = 0;  // triangles dropped: two corners at one vertex
    std::uint64_t zero_area = 0;       // collinear corners, whatever became of them
    std::uint64_t duplicates = 0;      // triangles dropped: same corners, same side
    std::uint64_t unused_locks = 0;    // locked vertices dropped with the vertices nobody uses
    std::vector<Finding> findings;
};

// A triangle with three collinear corners is not simply dropped, that would tear its neighbours apart: its long side is
// split, so that it shares the neighbour's area. It goes only where that side is open, and stays where it cannot be
// split. Vertices keep their order.
[[nodiscard]] Cleaned clean(const Surface& surface, Welded& welded);

}
