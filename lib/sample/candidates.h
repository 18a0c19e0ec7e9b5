// SPDX-License-Identifier: GPL-3.0-or-later
// Random places that may take a point. The i-th draw is a function of the seed and i alone.
#pragma once
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "core/vec3.h"
#include "sample/cells.h"
#include "sample/space.h"

namespace crumple::sample {

struct Candidate {
    Vec3 position;          // rounded to float, fillable, far enough from the shell
    double size = 0;        // h there
    double vertex_gap = 0;  // distance to the nearest shell vertex in h, infinity beyond Drawing::vertex_gap
};

// How many points per volume are wanted, up to a factor.
enum class Density {
    by_size,  // 1 / h^3
    even,     // the same everywhere, or as painted: 1 / (factor of h)^3
};

struct Drawing {
    const Space& space;
    const std::vector<Cell>& cells;
    Density density = Density::by_size;
    double clearance = 0;   // of points from the shell, in h
    double vertex_gap = 0;  // up to which the distance to the nearest shell vertex is of interest, in h
    std::uint64_t seed = 0;
};

struct Draws {
    std::vector<Candidate> candidates;  // in the order of their draws
    std::uint64_t tries = 0;
};

// Draws until there are `count` candidates, or 50 * count + 10 000 tries were made, or 20 000 tries and more find less
// than one candidate in 500: then there is hardly any room.
[[nodiscard]] Draws draw_candidates(const Drawing& drawing, std::uint64_t count, const Context& context);

}
