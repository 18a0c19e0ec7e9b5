// SPDX-License-Identifier: MIT
#include "solver/slices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "solver/body.h"
#include "solver/solve.h"

namespace crumple::solver::test {
namespace {

Bundle one_tet() { return bundle_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}, elastic_material()); }

// More than one piece of nodes, the last slice not full, rows of all lengths, some of them locked.
Bundle ragged() {
    const Bundle body =
        grid_body({9, 6, 4}, {0.3f, 0.2f, 0.25f}, elastic_material(), [](Vec3f p) { return p.x < 0.5f; });
    return with_shuffled_nodes(body, 7);
}

std::vector<Bundle> bodies() { return {one_tet(), grid_body({3, 3, 2}, {1, 1, 1}, elastic_material()), ragged()}; }

Index row_of(const Model& model, std::size_t number) {
    const auto& start = model.slices.start;
    const auto after = std::upper_bound(start.begin(), start.end(), number / slice_rows);
    const auto slice = static_cast<std::size_t>(after - start.begin()) - 1;
    return model.slices.node[slice_rows * slice + number % slice_rows];
}

}

TEST(Slices, HoldEveryBlockOnceTheDiagonalFirst) {
    for (const Bundle& bundle : bodies()) {
        const Body body(bundle);
        std::set<std::size_t> numbers;
        for (Index row = 0; row < body.node_count(); ++row) {
            std::vector<Index> columns;
            for_row(body.model.slices, row, [&](Index column, std::size_t number) {
                columns.push_back(column);
                numbers.insert(number);
                EXPECT_EQ(row_of(body.model, number), row);
            });
            EXPECT_EQ(columns.front(), row);
            std::sort(columns.begin(), columns.end());
            EXPECT_TRUE(std::equal(columns.begin(), columns.end(), bundle.column.begin() + bundle.row_start[row],
                                   bundle.column.begin() + bundle.row_start[row + 1]))
                << row;
        }
        EXPECT_EQ(numbers.size(), bundle.column.size());
    }
}

TEST(Slices, EdgesWriteTheBlocksOfTheirTwoRows) {
    for (const Bundle& bundle : bodies()) {
        const Body body(bundle);
        for (std::size_t e = 0; e < bundle.edges.size(); ++e) {
            const auto [i, j] = bundle.edges[e];
            const auto [ij, ji] = body.model.edge_block[e];
            EXPECT_EQ(row_of(body.model, ij), i);
            EXPECT_EQ(row_of(body.model, ji), j);
            EXPECT_EQ(body.model.slices.column[ij], j);
            EXPECT_EQ(body.model.slices.column[ji], i);
        }
    }
}

// Places whose blocks are not of the matrix cost memory and time.
TEST(Slices, SortedRowsLeaveLittleOver) {
    const Body body(grid_body({20, 10, 10}, {1, 1, 1}, elastic_material()));
    EXPECT_LT(slice_rows * body.model.group_count, 1.02 * static_cast<double>(body.bundle.column.size()));
}

// Nobody asks what fixed rows hold. Every instruction set, against the blocks taken one by one in double.
TEST(Slices, TheProductIsThatOfEachBlock) {
    for (const Bundle& bundle : bodies()) {
        for (const Isa isa : {Isa::scalar, Isa::avx2, Isa::avx512}) {
            if (best_isa(isa) != isa) continue;
            Settings settings;
            settings.isa = isa;
            Body body(bundle, settings);
            body.step(0.02f);
            Rng rng(3);
            for (std::size_t node = 0; node < body.node_count(); ++node) {
                const Vec3f x = random_vector(rng);
                for (int i = 0; i < 3; ++i) body.workspace.direction[4 * node + static_cast<std::size_t>(i)] = x[i];
            }
            kernels(isa).multiply(solve_job(body.model, body.workspace), 0, body.node_count());
            for (Index row = 0; row < body.node_count(); ++row) {
                Vec3 sum;
                double size = 0;
                for_row(body.model.slices, row, [&](Index column, std::size_t number) {
                    const float* x = &body.workspace.direction[4 * std::size_t{column}];
                    const Mat3 block = block_at(body.workspace.blocks, number);
                    for (int i = 0; i < 3; ++i) sum[i] += dot(widen(block.row(i)), Vec3{x[0], x[1], x[2]});
                    size += static_cast<double>(norm(block));
                });
                if (body.workspace.is_fixed[row]) continue;
                for (int i = 0; i < 3; ++i) {
                    const float product = body.workspace.product[4 * row + static_cast<std::size_t>(i)];
                    EXPECT_NEAR(product, sum[i], 1e-6 * size) << name_of(isa) << " row " << row;
                }
            }
        }
    }
}

}
