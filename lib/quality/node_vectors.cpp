// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/node_vectors.h"

#include "core/random.h"

namespace crumple::quality {

std::vector<Vec3> noise(std::size_t count, std::uint64_t seed) {
    Rng rng(seed);
    std::vector<Vec3> values(count);
    for (Vec3& v : values) {
        v.x = 2 * rng.next_unit() - 1;
        v.y = 2 * rng.next_unit() - 1;
        v.z = 2 * rng.next_unit() - 1;
    }
    return values;
}

}
