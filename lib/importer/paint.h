// SPDX-License-Identifier: GPL-3.0-or-later
// What the colours say: which vertices are locked.
#pragma once
#include <cstdint>
#include <vector>

#include "core/finding.h"
#include "importer/format.h"
#include "importer/scene.h"
#include "importer/surface.h"

namespace crumple::importer {

// Half of the smallest red an 8-bit picture can hold above 0: 8-bit red 1 is not locked, 16-bit red 1 is.
inline constexpr float locked_below = 0.5f / 255;

// Of a stored red. What is no finite number locks nothing.
[[nodiscard]] bool is_locked(float red);

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
[[nodiscard]] PaintedVertices read_paint(const Scene& scene, const Format& format, const Params& params,
                                         Surface& surface);

}
