// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tet_clearance.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "mesh/shapes.h"

namespace crumple {
namespace {

constexpr std::array<Vec3, 4> unit_tet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

TEST(TetClearance, TouchingFromOutsideIsClear) {
    EXPECT_FALSE(may_enter({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, unit_tet));        // a face
    EXPECT_FALSE(may_enter({{{0, 0, 0}, {1, 0, 0}, {0.5, 0.5, -1}}}, unit_tet));   // an edge
    EXPECT_FALSE(may_enter({{{0, 0, 0}, {-1, 0, 0}, {0, -1, 0.5}}}, unit_tet));    // a corner
    EXPECT_FALSE(may_enter({{{0.2, 0.2, 0}, {5, 0, -1}, {0, 5, -1}}}, unit_tet));  // a point of a face
    EXPECT_FALSE(
        may_enter({{{0, 0, 0}, {2, -1, 0.1}, {2, -1, 3}}}, unit_tet));  // a corner, crossing every face's plane
}

TEST(TetClearance, PassingThroughIsNotClear) {
    EXPECT_TRUE(may_enter({{{-1, -1, 0.2}, {3, -1, 0.2}, {-1, 3, 0.2}}}, unit_tet));
    EXPECT_TRUE(may_enter({{{0.1, 0.1, 0.1}, {0.2, 0.1, 0.1}, {0.1, 0.2, 0.1}}}, unit_tet));  // wholly inside
    EXPECT_TRUE(may_enter({{{0, 0, 0}, {1, 1, 1}, {2, 1, 1}}}, unit_tet));                    // from a corner inwards
}

TEST(TetClearance, NeverClearsATriangleThatHasAPointInside) {
    Rng rng(5);
    const auto random = [&] {
        const double x = rng.next_unit() * 3 - 1;
        const double y = rng.next_unit() * 3 - 1;
        return Vec3{x, y, rng.next_unit() * 3 - 1};
    };
    int entering = 0;
    for (int i = 0; i < 3000; ++i) {
        const Corners t{random(), random(), random()};
        bool has_inside = false;
        for (int u = 0; u <= 20; ++u) {
            for (int v = 0; u + v <= 20; ++v) {
                const Vec3 p = t[0] + (t[1] - t[0]) * (u / 20.0) + (t[2] - t[0]) * (v / 20.0);
                has_inside = has_inside || (p.x > 1e-9 && p.y > 1e-9 && p.z > 1e-9 && p.x + p.y + p.z < 1 - 1e-9);
            }
        }
        entering += has_inside;
        if (has_inside) {
            EXPECT_TRUE(may_enter(t, unit_tet)) << i;
        }
    }
    EXPECT_GT(entering, 200);
}

TEST(TetClearance, AGridOfABoxIsClearOfItsOwnSurface) {
    const TetClearance clearance(shapes::subdivided_box(3));
    const TetMesh grid = shapes::tet_grid(3);
    for (const auto& [a, b, c, d] : grid.tets) {
        EXPECT_TRUE(clearance.is_clear({grid.positions[a], grid.positions[b], grid.positions[c], grid.positions[d]}));
    }
}

}
}
