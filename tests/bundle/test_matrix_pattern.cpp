// SPDX-License-Identifier: MIT
#include "bundle/matrix_pattern.h"

#include <gtest/gtest.h>

#include <set>

#include "bundle/small_bundle.h"
#include "core/error.h"

using namespace crumple;

TEST(MatrixPattern, WithoutTetsEveryRowIsItsDiagonal) {
    Bundle b;
    b.rest_positions.resize(3);
    build_matrix_pattern(b);
    EXPECT_EQ(b.row_start, (std::vector<Index>{0, 1, 2, 3}));
    EXPECT_EQ(b.column, (std::vector<Index>{0, 1, 2}));
    EXPECT_EQ(b.diagonal, (std::vector<Index>{0, 1, 2}));
    EXPECT_TRUE(b.edges.empty());
    EXPECT_EQ(b.edge_start, (std::vector<Index>{0}));
}

TEST(MatrixPattern, OneTetFillsSixteenBlocksRowByRow) {
    Bundle b;
    b.rest_positions.resize(4);
    b.tets = {{2, 0, 1, 3}};
    b.solver_tet_count = 1;
    build_matrix_pattern(b);
    EXPECT_EQ(b.column.size(), 16u);
    EXPECT_EQ(b.edges.size(), 6u);
    for (std::size_t k = 0; k < 16; ++k) EXPECT_EQ(b.element_slots[0][k], 4 * b.tets[0][k / 4] + b.tets[0][k % 4]);
}

TEST(MatrixPattern, AllLockedTetsDoNotEnter) {
    Bundle with = test::small_bundle();
    Bundle without = with;
    without.tets.resize(without.solver_tet_count);
    build_matrix_pattern(without);
    EXPECT_EQ(with.column, without.column);
    EXPECT_EQ(with.edge_tet, without.edge_tet);
}

TEST(MatrixPattern, NoTwoEdgesWriteTheSameBlock) {
    const Bundle b = test::small_bundle(5);
    std::set<Index> written;
    for (const auto& slots : b.edge_slots) {
        for (const Index slot : slots) EXPECT_TRUE(written.insert(slot).second) << "block " << slot;
    }
    EXPECT_EQ(written.size() + b.diagonal.size(), b.column.size());
}

TEST(MatrixPattern, RefusesMoreBlocksThanIndicesCanName) {
    Bundle b;
    b.rest_positions.resize(4);
    b.solver_tet_count = none / 16 + 1;
    EXPECT_THROW(build_matrix_pattern(b), Error);
}
