// SPDX-License-Identifier: MIT
#include "samples/icosphere.h"

#include <map>

namespace crumple::samples {
namespace {

Vec3 unit(Vec3 v) { return v / length(v); }

Icosphere icosahedron() {
    const double g = (1 + std::sqrt(5.0)) / 2;  // golden ratio
    Icosphere ball;
    for (const Vec3 v : {Vec3{-1, g, 0},
                         {1, g, 0},
                         {-1, -g, 0},
                         {1, -g, 0},
                         {0, -1, g},
                         {0, 1, g},
                         {0, -1, -g},
                         {0, 1, -g},
                         {g, 0, -1},
                         {g, 0, 1},
                         {-g, 0, -1},
                         {-g, 0, 1}}) {
        ball.directions.push_back(unit(v));
    }
    ball.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    return ball;
}

Icosphere subdivided(const Icosphere& coarse) {
    Icosphere fine{coarse.directions, {}};
    std::map<Edge, Index> middles;
    const auto middle = [&](Index a, Index b) {
        const auto [entry, is_new] =
            middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<Index>(fine.directions.size()));
        if (is_new) fine.directions.push_back(unit(fine.directions[a] + fine.directions[b]));
        return entry->second;
    };
    for (const auto& [a, b, c] : coarse.triangles) {
        const Index ab = middle(a, b);
        const Index bc = middle(b, c);
        const Index ca = middle(c, a);
        for (const Triangle& t : {Triangle{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
            fine.triangles.push_back(t);
    }
    return fine;
}

}

Icosphere icosphere(int level) {
    Icosphere ball = icosahedron();
    for (int i = 0; i < level; ++i) ball = subdivided(ball);
    return ball;
}

}
