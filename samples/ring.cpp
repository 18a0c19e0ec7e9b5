// SPDX-License-Identifier: MIT
#include "samples/ring.h"

#include "samples/solids.h"

namespace crumple::samples {

Model ring_shell() {
    Part part{"ring", {}, {}, {}};
    add_torus(part, {{0, 0.3, 0}, 1, 0.8, 0.3, 32, 12}, unlocked);
    for (std::size_t v = 0; v < part.positions.size(); ++v) {
        if (part.positions[v].x < -0.95) part.colors[v] = locked;
    }
    return {part};
}

Model ring_visual() {
    Part part{"ring", {}, {}, {}};
    add_torus(part, {{0, 0.3, 0}, 1, 0.8, 0.26, 96, 36}, unlocked);
    return {part};
}

}
