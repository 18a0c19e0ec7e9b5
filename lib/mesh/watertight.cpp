// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/watertight.h"

#include <algorithm>
#include <vector>

namespace crumple {

bool is_watertight(std::span<const Triangle> triangles) {
    std::vector<Edge> forward;
    std::vector<Edge> backward;
    for (const Triangle& triangle : triangles) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Index a = triangle[corner];
            const Index b = triangle[(corner + 1) % 3];
            if (a < b) forward.push_back({a, b});
            if (b < a) backward.push_back({b, a});
        }
    }
    std::sort(forward.begin(), forward.end());
    std::sort(backward.begin(), backward.end());
    return forward == backward;
}

}
