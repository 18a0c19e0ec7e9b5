// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/cells.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "mesh/shapes.h"
#include "sample/element_size.h"

using namespace crumple;
using namespace crumple::sample;

namespace {

Vec3 random_place(const Cell& cell, Rng& rng) {
    Vec3 p = cell.centre;
    for (int axis = 0; axis < 3; ++axis) p[axis] += (2 * rng.next_unit() - 1) * cell.half;
    return round_to_float(p);
}

TEST(Cells, AShellWithoutTrianglesHasNone) {
    const Shell nothing;
    EXPECT_TRUE(find_cells(Space(nothing, {}), 0.4, {}).empty());
}

TEST(Cells, TrianglesWithoutSizeHaveNone) {
    Shell shell = shapes::tetrahedron();
    for (Vec3& p : shell.positions) p = {1, 2, 3};
    EXPECT_TRUE(find_cells(Space(shell, {}), 0.4, {}).empty());
}

TEST(Cells, ListsGiveTheSizeAndDistanceOfTheWholeShell) {
    Shell shell = shapes::joined(shapes::torus(), shapes::icosphere(0.5, 3));
    const shapes::ElementSize expected(shell);
    const Space space(shell, {});
    Rng rng(41);
    const std::vector<Cell> cells = find_cells(space, 0.4, {});
    ASSERT_FALSE(cells.empty());
    for (std::size_t i = 0; i < cells.size(); i += 7) {
        const Vec3 p = random_place(cells[i], rng);
        EXPECT_DOUBLE_EQ(size_at(space, cells[i], p), expected.at(p));
        if (!cells[i].is_clear) {
            EXPECT_NEAR(distance_at(space, cells[i], p), expected.distance(p), 1e-9);
        }
    }
}

TEST(Cells, ClearCellsAreInsideAndFarEnoughEverywhere) {
    const Shell shell = shapes::subdivided_box(6);
    const shapes::ElementSize expected(shell);
    const Space space(shell, {});
    Rng rng(42);
    std::size_t clear = 0;
    for (const Cell& cell : find_cells(space, 0.4, {})) {
        if (!cell.is_clear) continue;
        ++clear;
        for (int i = 0; i < 10; ++i) {
            const Vec3 p = random_place(cell, rng);
            EXPECT_TRUE(space.is_fillable(p));
            EXPECT_GE(expected.distance(p), 0.4 * expected.at(p));
        }
    }
    EXPECT_GT(clear, 10u);
}

TEST(Cells, NoAllowedPlaceIsLeftOut) {
    const Shell shell =
        shapes::joined(shapes::subdivided_box(4, {0, 0, 0}, {1, 1, 1}), shapes::icosphere(0.3, 2, {3, 0, 0}));
    const shapes::ElementSize expected(shell);
    const Space space(shell, {});
    const std::vector<Cell> cells = find_cells(space, 0.4, {});
    Rng rng(43);
    int allowed = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 p{rng.next_unit() * 4 - 0.4, rng.next_unit() * 1.5 - 0.4, rng.next_unit() * 1.5 - 0.4};
        if (!space.is_fillable(p) || expected.distance(p) < 0.4 * expected.at(p)) continue;
        ++allowed;
        const bool is_covered = std::any_of(cells.begin(), cells.end(), [&](const Cell& cell) {
            const Vec3 off = p - cell.centre;
            return std::abs(off.x) <= cell.half && std::abs(off.y) <= cell.half && std::abs(off.z) <= cell.half;
        });
        EXPECT_TRUE(is_covered) << p.x << ' ' << p.y << ' ' << p.z;
    }
    EXPECT_GT(allowed, 50);
}

TEST(Cells, AreTheSameForAnyNumberOfThreads) {
    const Shell shell = shapes::torus();
    const Space space(shell, {});
    Context four;
    four.jobs = 4;
    const std::vector<Cell> alone = find_cells(space, 0.4, {});
    const std::vector<Cell> together = find_cells(space, 0.4, four);
    ASSERT_EQ(alone.size(), together.size());
    for (std::size_t i = 0; i < alone.size(); ++i) {
        EXPECT_EQ(alone[i].centre, together[i].centre);
        EXPECT_EQ(alone[i].size, together[i].size);
        EXPECT_EQ(alone[i].vertices, together[i].vertices);
    }
}

}
