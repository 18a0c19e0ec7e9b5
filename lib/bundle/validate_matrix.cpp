// SPDX-License-Identifier: MIT
// Proves that the sparse matrix is the one the solver tets need without building it a second time: every needed block
// is there, every block is needed, and rows ascend, so nothing is there twice.
#include <algorithm>

#include "bundle/validate_parts.h"

namespace crumple {
namespace {

bool is_in_row(const Bundle& b, Index slot, Index row) {
    return slot >= b.row_start[row] && slot < b.row_start[row + 1];
}

bool is_block(const Bundle& b, Index slot, Index row, Index column) {
    return is_in_row(b, slot, row) && b.column[slot] == column;
}

void check_rows(const Bundle& b, Complaints& complaints) {
    for (Index row = 0; row + 1 < b.row_start.size(); ++row) {
        for (Index k = b.row_start[row] + 1; k < b.row_start[row + 1]; ++k) {
            if (b.column[k - 1] >= b.column[k]) {
                complaints.add("BUNDLE_MATRIX", "the columns of a row do not ascend", row, b.rest_positions[row]);
                break;
            }
        }
        if (!is_block(b, b.diagonal[row], row, row)) {
            complaints.add("BUNDLE_MATRIX", "a row's diagonal is not its diagonal block", row, b.rest_positions[row]);
        }
    }
}

// The six edges of each tet, to be visited exactly once: bit of the corner pair (a, b), a < b.
int pair_bit(int a, int b) {
    for (int pair = 0; pair < 6; ++pair) {
        if (tet_edge_corners[pair][0] == std::min(a, b) && tet_edge_corners[pair][1] == std::max(a, b))
            return 1 << pair;
    }
    return 0;
}

void check_incidences(const Bundle& b, Complaints& complaints) {
    std::vector<std::uint8_t> seen(b.solver_tet_count, 0);
    for (std::size_t e = 0; e < b.edges.size(); ++e) {
        for (Index k = b.edge_start[e]; k < b.edge_start[e + 1]; ++k) {
            const Tet& tet = b.tets[b.edge_tet[k]];
            const auto [i, j] = b.edge_corners[k];
            const int bit = pair_bit(i, j);
            std::uint8_t& pairs = seen[b.edge_tet[k]];
            if (tet[i] != b.edges[e][0] || tet[j] != b.edges[e][1] || bit == 0 || (pairs & bit)) {
                complaints.add("BUNDLE_EDGES", "an edge's list of tets names a wrong corner or one twice",
                               static_cast<Index>(e), b.rest_positions[b.edges[e][0]]);
            }
            pairs = static_cast<std::uint8_t>(pairs | bit);
        }
    }
}

}

void check_matrix(const Bundle& b, Complaints& complaints) {
    check_rows(b, complaints);
    std::vector<std::uint8_t> is_needed(b.column.size(), 0);
    for (const Index slot : b.diagonal) is_needed[slot] = 1;
    for (Index t = 0; t < b.solver_tet_count; ++t) {
        for (std::size_t k = 0; k < 16; ++k) {
            const Index slot = b.element_slots[t][k];
            is_needed[slot] = 1;
            if (!is_block(b, slot, b.tets[t][k / 4], b.tets[t][k % 4])) {
                complaints.add("BUNDLE_SLOTS", "an element slot is not the block of its two corners", t,
                               b.rest_positions[b.tets[t][0]]);
            }
        }
    }
    for (Index slot = 0; slot < is_needed.size(); ++slot) {
        if (!is_needed[slot]) complaints.add("BUNDLE_MATRIX", "a block belongs to no tet", slot);
    }
}

void check_edges(const Bundle& b, Complaints& complaints) {
    if (b.column.size() != b.diagonal.size() + 2 * b.edges.size()) {
        complaints.add("BUNDLE_EDGES", "there is not one edge for every pair of blocks beside the diagonal");
    }
    for (std::size_t e = 0; e < b.edges.size(); ++e) {
        const auto [i, j] = b.edges[e];
        const bool ascends = i < j && (e == 0 || b.edges[e - 1] < b.edges[e]);
        if (!ascends || !is_block(b, b.edge_slots[e][0], i, j) || !is_block(b, b.edge_slots[e][1], j, i)) {
            complaints.add("BUNDLE_EDGES", "an edge is out of order or its slots are not its two blocks",
                           static_cast<Index>(e), b.rest_positions[i]);
        }
    }
    check_incidences(b, complaints);
}

}
