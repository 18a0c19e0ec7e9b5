// SPDX-License-Identifier: MIT
// Where the blocks of the matrix lie. Rows share slices, eight side by side, so that a kernel takes eight rows at once
// and none of its loops ends early [Monakov, Lokhmotov, Avetisyan 2010, "Automatically tuning sparse matrix-vector
// multiplication for GPU architectures"; Kreutzer et al. 2014, SELL-C-sigma]. Rows of one length come together, as they
// are sorted by it within a piece of the loops.
//
// Group k of a slice holds block k of each of its rows, element by element (column-major), eight floats an element. A
// row begins with its diagonal block; where others of its slice are longer it ends in blocks of zeros, whose column is
// that of its first.
#pragma once
#include <array>
#include <span>

#include "core/index.h"
#include "solver/mat3.h"

namespace crumple::solver {

struct BundleView;

inline constexpr std::size_t slice_rows = 8;
inline constexpr std::size_t group_floats = 9 * slice_rows;

// Nodes of a piece of the loops: whole slices, and large enough to be worth a thread.
inline constexpr std::size_t nodes_per_piece = 256;

// N nodes. A block's number is 8 group + lane.
struct Slices {
    std::span<const Index> lane;    // N: 8 slice + lane of the node's row
    std::span<const Index> node;    // 8 a slice: whose row it is; past the last node where there are no more
    std::span<const Index> start;   // slices + 1: its first group
    std::span<const Index> column;  // 8 a group
};

struct SliceCounts {
    std::size_t slices = 0;
    std::size_t groups = 0;
};
// REQUIRES, as fill_slices does: first_problem(view) is null.
[[nodiscard]] SliceCounts count_slices(const BundleView& view);

// As Slices has them; edge_block (E) becomes the numbers of the blocks of (i, j) and of (j, i).
struct SliceArrays {
    std::span<Index> lane;
    std::span<Index> node;
    std::span<Index> start;
    std::span<Index> column;
    std::span<std::array<Index, 2>> edge_block;
};
void fill_slices(const BundleView& view, const SliceArrays& arrays);

[[nodiscard]] inline Mat3 block_at(std::span<const float> blocks, std::size_t number) {
    const float* first = &blocks[group_floats * (number / slice_rows) + number % slice_rows];
    Mat3 block;
    for (std::size_t i = 0; i < 9; ++i) block.m[3 * (i % 3) + i / 3] = first[slice_rows * i];
    return block;
}

// body(column, number of the block) over a row, the diagonal first.
template <class Body>
void for_row(const Slices& slices, std::size_t node, Body&& body) {
    const std::size_t slice = slices.lane[node] / slice_rows;
    const std::size_t lane = slices.lane[node] % slice_rows;
    for (std::size_t group = slices.start[slice]; group < slices.start[slice + 1]; ++group) {
        const Index column = slices.column[slice_rows * group + lane];
        if (column == node && group > slices.start[slice]) return;
        body(column, slice_rows * group + lane);
    }
}

}
