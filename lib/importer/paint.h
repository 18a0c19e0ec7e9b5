// SPDX-License-Identifier: GPL-3.0-or-later
// What the colours say: which vertices are locked.
#pragma once
#include <cstdint>
#include <vector>

#include "core/finding.h"
#include "formats/format.h"
#include "importer/scene.h"
#include "importer/surface.h"

namespace crumple::importer {

enum class Paint : std::uint8_t { none, free, locked };  // none: the file gives this vertex no colour

struct PaintedVertices {
    std::vector<Paint> paint;  // V of the surface
    std::uint64_t locked_count = 0;
    std::size_t set_count = 0;      // colour sets in the file
    std::vector<Finding> findings;  // what is odd about the colours as the file has them
};

// Scales surface.colors to 0..1 where the format may hold bytes and every value is a whole number, judges the stored
// red, then turns the colours linear where params say they are sRGB. Leaves surface.colors empty when nothing has one.
// Throws Error(usage) for a colour set that the file has not.
[[nodiscard]] PaintedVertices read_paint(const Scene& scene, const formats::Format& format, const Params& params,
                                         Surface& surface);

}
