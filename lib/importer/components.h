// SPDX-License-Identifier: GPL-3.0-or-later
// Splits the welded surface into components, makes each one's triangles agree on their outside, and counts its edges.
#pragma once
#include <cstdint>
#include <vector>

#include "core/finding.h"
#include "importer/surface.h"
#include "importer/weld.h"

namespace crumple::importer {

struct ComponentFacts {
    Index object = 0;  // of the surface, of its first triangle
    Index part = 0;    // of its first triangle
    std::uint64_t triangle_count = 0;
    double signed_volume = 0;  // cubic metres; negative: wound inwards
    bool is_closed = false;    // every edge is passed as often one way as the other
};

struct Components {
    std::vector<Index> of_triangle;  // F
    std::vector<ComponentFacts> facts;
    std::uint64_t flipped = 0;             // triangles turned to agree with the most of their patch
    std::uint64_t open_edges = 0;          // one triangle
    std::uint64_t non_manifold_edges = 0;  // more than two triangles, not counting where closed components touch
    std::vector<Finding> findings;
};

// Triangles that share a vertex belong together. Objects that are closed by themselves stay apart from others that
// touch them; open ones are joined with each other, for many a surface is cut into objects by name or material.
// Turns triangles of shell where neighbours disagree.
[[nodiscard]] Components split_components(const Surface& surface, Welded& shell);

}
