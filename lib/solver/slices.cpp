// SPDX-License-Identifier: MIT
#include "solver/slices.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "solver/model.h"

namespace crumple::solver {
namespace {

// The rows of one piece in the order they enter its slices: locked ones apart, for a step may leave them out; by
// length; by index.
class SortedRows {
public:
    SortedRows(const BundleView& view, std::size_t begin) : view_(view) {
        const std::size_t count = std::min(nodes_per_piece, view.rest_positions.size() - begin);
        rows_ = std::span(memory_).first(count);
        std::iota(rows_.begin(), rows_.end(), static_cast<Index>(begin));
        std::sort(rows_.begin(), rows_.end(), [&](Index a, Index b) {
            if ((view.locked[a] != 0) != (view.locked[b] != 0)) return view.locked[a] == 0;
            return length(a) != length(b) ? length(a) < length(b) : a < b;
        });
    }
    SortedRows(const SortedRows&) = delete;
    SortedRows& operator=(const SortedRows&) = delete;

    [[nodiscard]] Index length(Index row) const { return view_.row_start[row + 1] - view_.row_start[row]; }
    [[nodiscard]] std::size_t slice_count() const { return (rows_.size() + slice_rows - 1) / slice_rows; }
    [[nodiscard]] std::span<const Index> slice(std::size_t i) const {
        return rows_.subspan(slice_rows * i, std::min(slice_rows, rows_.size() - slice_rows * i));
    }
    [[nodiscard]] Index longest(std::size_t i) const {
        Index longest = 0;
        for (const Index row : slice(i)) longest = std::max(longest, length(row));
        return longest;
    }

private:
    const BundleView& view_;
    std::array<Index, nodes_per_piece> memory_{};
    std::span<Index> rows_;
};

// Columns of a row in their new order: the diagonal first. The number of steps a block has from the first of its row.
Index steps_to(const BundleView& view, Index row, Index slot) {
    const Index diagonal = view.diagonal[row];
    const Index before = slot - view.row_start[row];
    if (slot == diagonal) return 0;
    return slot < diagonal ? before + 1 : before;
}

void fill_columns(const BundleView& view, const SliceArrays& a, std::size_t slice, std::size_t lane, Index row) {
    for (Index group = a.start[slice]; group < a.start[slice + 1]; ++group) a.column[slice_rows * group + lane] = row;
    for (Index slot = view.row_start[row]; slot < view.row_start[row + 1]; ++slot) {
        a.column[slice_rows * (a.start[slice] + steps_to(view, row, slot)) + lane] = view.column[slot];
    }
}

void fill_slice(const BundleView& view, const SliceArrays& a, std::size_t slice, std::span<const Index> rows) {
    const auto node_count = static_cast<Index>(view.rest_positions.size());
    for (std::size_t lane = 0; lane < slice_rows; ++lane) {
        const bool is_used = lane < rows.size();
        // The last slice of all may have lanes over.
        const auto beyond = static_cast<Index>(node_count + lane - rows.size());
        a.node[slice_rows * slice + lane] = is_used ? rows[lane] : beyond;
        if (is_used) {
            a.lane[rows[lane]] = static_cast<Index>(slice_rows * slice + lane);
            fill_columns(view, a, slice, lane, rows[lane]);
            continue;
        }
        for (Index g = a.start[slice]; g < a.start[slice + 1]; ++g) a.column[slice_rows * g + lane] = node_count - 1;
    }
}

Index block_of(const BundleView& view, const SliceArrays& a, Index row, Index slot) {
    const Index lane = a.lane[row];
    const Index group = a.start[lane / slice_rows] + steps_to(view, row, slot);
    return static_cast<Index>(slice_rows * group + lane % slice_rows);
}

}

SliceCounts count_slices(const BundleView& view) {
    SliceCounts counts;
    for (std::size_t begin = 0; begin < view.rest_positions.size(); begin += nodes_per_piece) {
        const SortedRows rows(view, begin);
        for (std::size_t i = 0; i < rows.slice_count(); ++i) counts.groups += rows.longest(i);
        counts.slices += rows.slice_count();
    }
    return counts;
}

void fill_slices(const BundleView& view, const SliceArrays& a) {
    std::size_t slice = 0;
    a.start[0] = 0;
    for (std::size_t begin = 0; begin < view.rest_positions.size(); begin += nodes_per_piece) {
        const SortedRows rows(view, begin);
        for (std::size_t i = 0; i < rows.slice_count(); ++i, ++slice) {
            a.start[slice + 1] = a.start[slice] + rows.longest(i);
            fill_slice(view, a, slice, rows.slice(i));
        }
    }
    for (std::size_t e = 0; e < view.edges.size(); ++e) {
        for (std::size_t end = 0; end < 2; ++end) {
            a.edge_block[e][end] = block_of(view, a, view.edges[e][end], view.edge_slots[e][end]);
        }
    }
}

}
