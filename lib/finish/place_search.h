// SPDX-License-Identifier: GPL-3.0-or-later
// Where a node should go when what is asked of its place has no gradient to follow.
#pragma once
#include "core/vec3.h"

namespace crumple::finish {

// The best place found, float-representable unless it is `start`: rounds of steps along the axes, both ways, half as
// long when none was better. `reach`: from the start to the farthest corner of the node's tets. `lack`: what is wrong
// with the start; lack_at(place, limit): with another, or anything from `limit` on where it is no less than that.
template <class LackAt>
[[nodiscard]] Vec3 search_place(Vec3 start, double reach, double lack, LackAt&& lack_at) {
    constexpr int rounds = 8;
    constexpr double first_stride = 0.2;  // of the reach
    double stride = first_stride * reach;
    Vec3 best = start;
    for (int round = 0; round < rounds; ++round) {
        const Vec3 from = best;
        for (int direction = 0; direction < 6; ++direction) {
            Vec3 by;
            by[direction / 2] = direction % 2 == 0 ? stride : -stride;
            const Vec3 place = round_to_float(from + by);
            const double here = lack_at(place, lack);
            if (!(here < lack)) continue;
            lack = here;
            best = place;
        }
        if (best == from) stride *= 0.5;
    }
    return best;
}

}
