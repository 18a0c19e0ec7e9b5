// SPDX-License-Identifier: GPL-3.0-or-later
// Where an interior node should go so that the worst tet at it gets as good as it can [Freitag and Ollivier-Gooch 1997,
// "Tetrahedral mesh improvement using swapping and smoothing"]: steepest ascent of a minimum of smooth functions. The
// direction is the shortest vector in the convex hull of the gradients of the functions that are nearly the minimum.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "finish/shape.h"

namespace crumple::finish {

struct BetterPlace {
    Vec3 place;    // float-representable
    double least;  // shape of the worst tet there
};

// Where the node may go.
struct Leash {
    Vec3 normal{};         // it moves in the plane across this; zero: in space
    double reach = 1e300;  // no farther than this in all
};

// None where no step makes the worst tet better than `floor`. Tets at the new place have a positive shape, as floating
// point sees it. Reorders `faces`.
[[nodiscard]] std::optional<BetterPlace> find_better_place(Vec3 node, std::vector<OppositeFace>& faces, double floor,
                                                           const Leash& leash = {});

// The vector of least length in the convex hull of `vectors`, to about a percent; zero for none.
[[nodiscard]] Vec3 shortest_in_hull(std::span<const Vec3> vectors);

}
