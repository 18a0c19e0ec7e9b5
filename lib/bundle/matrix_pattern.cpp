// SPDX-License-Identifier: MIT
#include "bundle/matrix_pattern.h"

#include <algorithm>
#include <span>

#include "core/error.h"

namespace crumple {
namespace {

std::span<const Tet> solver_tets(const Bundle& bundle) { return {bundle.tets.data(), bundle.solver_tet_count}; }

// One edge as one tet sees it, i < j.
struct Incidence {
    Edge edge;
    Index tet;
    std::array<std::uint8_t, 2> corners;

    friend bool operator<(const Incidence& a, const Incidence& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.tet < b.tet;
    }
};

std::vector<Incidence> list_incidences(std::span<const Tet> tets) {
    std::vector<Incidence> incidences;
    incidences.reserve(6 * tets.size());
    for (Index t = 0; t < tets.size(); ++t) {
        for (const auto& [a, b] : tet_edge_corners) {
            auto i = static_cast<std::uint8_t>(a);
            auto j = static_cast<std::uint8_t>(b);
            if (tets[t][i] > tets[t][j]) std::swap(i, j);
            incidences.push_back({{tets[t][i], tets[t][j]}, t, {i, j}});
        }
    }
    std::sort(incidences.begin(), incidences.end());
    return incidences;
}

void fill_edges(Bundle& bundle) {
    bundle.edges.clear();
    bundle.edge_start.clear();
    bundle.edge_tet.clear();
    bundle.edge_corners.clear();
    for (const Incidence& incidence : list_incidences(solver_tets(bundle))) {
        if (bundle.edges.empty() || bundle.edges.back() != incidence.edge) {
            bundle.edges.push_back(incidence.edge);
            bundle.edge_start.push_back(static_cast<Index>(bundle.edge_tet.size()));
        }
        bundle.edge_tet.push_back(incidence.tet);
        bundle.edge_corners.push_back(incidence.corners);
    }
    bundle.edge_start.push_back(static_cast<Index>(bundle.edge_tet.size()));
}

void count_rows(Bundle& bundle) {
    bundle.row_start.assign(bundle.rest_positions.size() + 1, 0);
    for (const auto& [i, j] : bundle.edges) {
        ++bundle.row_start[i + 1];
        ++bundle.row_start[j + 1];
    }
    for (std::size_t row = 0; row < bundle.rest_positions.size(); ++row) {
        bundle.row_start[row + 1] += bundle.row_start[row] + 1;  // and the diagonal
    }
}

// Edges ascend by (i, j), so a first pass over them puts each row's columns below the diagonal in order (rows j take
// i), then the diagonals, then a second pass those above it (rows i take j).
void fill_columns(Bundle& bundle) {
    const std::size_t node_count = bundle.rest_positions.size();
    bundle.column.resize(bundle.row_start.back());
    bundle.diagonal.resize(node_count);
    bundle.edge_slots.resize(bundle.edges.size());
    std::vector<Index> next(bundle.row_start.begin(), bundle.row_start.end() - 1);
    const auto put = [&](Index row, Index col) {
        bundle.column[next[row]] = col;
        return next[row]++;
    };
    for (std::size_t e = 0; e < bundle.edges.size(); ++e) {
        bundle.edge_slots[e][1] = put(bundle.edges[e][1], bundle.edges[e][0]);
    }
    for (Index node = 0; node < node_count; ++node) bundle.diagonal[node] = put(node, node);
    for (std::size_t e = 0; e < bundle.edges.size(); ++e) {
        bundle.edge_slots[e][0] = put(bundle.edges[e][0], bundle.edges[e][1]);
    }
}

void fill_element_slots(Bundle& bundle) {
    bundle.element_slots.resize(bundle.solver_tet_count);
    for (Index t = 0; t < bundle.solver_tet_count; ++t) {
        for (std::size_t corner = 0; corner < 4; ++corner) {
            bundle.element_slots[t][5 * corner] = bundle.diagonal[bundle.tets[t][corner]];
        }
    }
    for (std::size_t e = 0; e < bundle.edges.size(); ++e) {
        for (Index k = bundle.edge_start[e]; k < bundle.edge_start[e + 1]; ++k) {
            const auto [i, j] = bundle.edge_corners[k];
            auto& slots = bundle.element_slots[bundle.edge_tet[k]];
            slots[std::size_t{4} * i + j] = bundle.edge_slots[e][0];
            slots[std::size_t{4} * j + i] = bundle.edge_slots[e][1];
        }
    }
}

}

void build_matrix_pattern(Bundle& bundle) {
    if (std::size_t{16} * bundle.solver_tet_count + bundle.rest_positions.size() >= none) {
        throw Error(ErrorKind::budget, "bundle: too many tets for 32-bit block indices; sample fewer points");
    }
    fill_edges(bundle);
    count_rows(bundle);
    fill_columns(bundle);
    fill_element_slots(bundle);
}

}
