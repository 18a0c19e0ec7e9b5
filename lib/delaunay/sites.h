// SPDX-License-Identifier: GPL-3.0-or-later
// The points as the hull sees them: distinct, along a Hilbert curve, scaled by one exact power of two.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple::delaunay {

struct alignas(32) Site {
    double x;
    double y;
    double z;
    // Scratch of the insertion at hand: which one it is, and the number of this site in its star.
    std::uint32_t stamp;
    std::uint32_t local;

    [[nodiscard]] Vec3 position() const { return {x, y, z}; }
};

struct Sites {
    std::vector<Site> at;             // S sites in Hilbert order, then one for the vertex at infinity
    std::vector<Index> source;        // S: the point with the lowest index at that place
    std::vector<Index> duplicate_of;  // per point, empty when all are distinct

    // Every coordinate is a multiple of this power of two; 0 when it is too small to be of use.
    double grain = 0;
    // Exponents too far apart for floating-point planes: every decision is left to exact arithmetic.
    bool exact_only = false;

    [[nodiscard]] Index count() const { return static_cast<Index>(source.size()); }
    [[nodiscard]] Index infinity() const { return count(); }
};

// Throws Error(bad_input) naming the first point with a NaN or infinite coordinate.
[[nodiscard]] Sites make_sites(std::span<const Vec3> positions);

}
