// SPDX-License-Identifier: GPL-3.0-or-later
// Merges the copies of a vertex that formats make for normals, materials and colours. A lock on any copy locks it.
#pragma once
#include <cstdint>
#include <vector>

#include "core/finding.h"
#include "importer/paint.h"
#include "importer/surface.h"

namespace crumple::importer {

struct Welded {
    std::vector<Vec3> positions;       // V, distinct, in the order of their first copy in the file
    std::vector<Color> colors;         // V or empty: the first coloured copy's
    std::vector<std::uint8_t> locked;  // V
    std::vector<Index> source_vertex;  // V: of the first copy
    std::vector<Triangle> triangles;   // F, as many and in the order they came
    std::vector<Index> part;           // F
    std::uint64_t exact_merges = 0;
    std::uint64_t tolerance_merges = 0;
    double farthest = 0;  // of a copy merged by tolerance from its vertex
    Finding conflicts;    // copies that disagree about the lock; count 0: none
};

// First by equal position; then, only where that leaves edges open, vertices of open edges join the nearest earlier one
// within max(tolerance times the box diagonal, 4 ulp). A painted copy's position wins, so a lock stays where it was
// painted.
[[nodiscard]] Welded weld(const Surface& surface, const PaintedVertices& painted, double tolerance);

}
