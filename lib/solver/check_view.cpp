// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "solver/model.h"

namespace crumple::solver {
namespace {

const char* size_problem(const BundleView& v) {
    const std::size_t node_count = v.rest_positions.size();
    const std::size_t tet_count = v.tets.size();
    if (node_count == 0 || tet_count == 0) return "the bundle has no tets to simulate";
    // 16 tet + corners and 4 tet + corner must fit an index.
    if (tet_count >= none / 16 || node_count >= none / 16) return "more tets or nodes than the solver can number";
    if (v.column.size() >= none / slice_rows) return "more blocks than the solver can number";
    if (v.mass.size() != node_count || v.locked.size() != node_count || v.diagonal.size() != node_count ||
        v.row_start.size() != node_count + 1) {
        return "arrays over nodes differ in length";
    }
    if (v.inverse_rest.size() != tet_count || v.volume.size() != tet_count || v.stiffness_scale.size() != tet_count ||
        v.material.size() != tet_count || v.edge_tet.size() != 6 * tet_count ||
        v.edge_corners.size() != 6 * tet_count) {
        return "arrays over tets differ in length";
    }
    if (v.edge_slots.size() != v.edges.size() || v.edge_start.size() != v.edges.size() + 1) {
        return "arrays over edges differ in length";
    }
    return nullptr;
}

bool are_starts(std::span<const Index> starts, std::size_t end) {
    return starts.front() == 0 && starts.back() == end && std::is_sorted(starts.begin(), starts.end());
}

bool is_block(const BundleView& v, Index slot, Index row, Index column) {
    return slot >= v.row_start[row] && slot < v.row_start[row + 1] && v.column[slot] == column;
}

const char* row_problem(const BundleView& v) {
    const std::size_t node_count = v.rest_positions.size();
    if (!are_starts(v.row_start, v.column.size())) return "row_start: does not rise from 0 to the number of blocks";
    if (std::any_of(v.column.begin(), v.column.end(), [&](Index c) { return c >= node_count; })) {
        return "column: a column is not a node";
    }
    for (Index row = 0; row < node_count; ++row) {
        if (!is_block(v, v.diagonal[row], row, row)) return "diagonal: a row's diagonal is not its diagonal block";
    }
    // Every block but the diagonal is written through an edge, each by one edge only.
    return v.column.size() == node_count + 2 * v.edges.size() ? nullptr : "column: blocks that no edge writes";
}

const char* edge_problem(const BundleView& v) {
    if (!are_starts(v.edge_start, v.edge_tet.size())) return "edge_start: does not rise from 0 to 6 per tet";
    for (std::size_t e = 0; e < v.edges.size(); ++e) {
        const auto [i, j] = v.edges[e];
        if (i >= j || j >= v.rest_positions.size()) return "edges: an edge is not two rising nodes";
        if (e > 0 && !(v.edges[e - 1] < v.edges[e])) return "edges: the edges do not ascend";
        if (!is_block(v, v.edge_slots[e][0], i, j) || !is_block(v, v.edge_slots[e][1], j, i)) {
            return "edge_slots: a slot is not the block of its edge";
        }
        for (Index k = v.edge_start[e]; k < v.edge_start[e + 1]; ++k) {
            const auto [a, b] = v.edge_corners[k];
            if (v.edge_tet[k] >= v.tets.size() || a > 3 || b > 3) return "edge_tet: not a corner of a tet";
            const Tet& tet = v.tets[v.edge_tet[k]];
            if (tet[a] != i || tet[b] != j) return "edge_corners: not the corners of the edge";
        }
    }
    return nullptr;
}

// Negated comparisons, so that a NaN fails them.
const char* material_problem(const BundleView& v) {
    for (const Material& m : v.materials) {
        if (!(m.young_pa > 0 && m.young_pa <= 1e13 && m.poisson >= 0 && m.poisson <= 0.499)) {
            return "materials: young_pa or poisson out of range";
        }
        if (!(m.density_kg_m3 > 0 && m.density_kg_m3 <= 1e6 && m.yield_pa >= 0 && m.creep_per_s >= 0 &&
              m.hardening_pa >= 0 && m.max_plastic_strain >= 0 && m.alpha_per_s >= 0 && m.beta_s >= 0)) {
            return "materials: a number out of range";
        }
    }
    return nullptr;
}

bool is_finite(Vec3f p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

const char* node_problem(const BundleView& v) {
    for (std::size_t i = 0; i < v.rest_positions.size(); ++i) {
        if (!is_finite(v.rest_positions[i])) return "rest_positions: not finite";
        if (!(v.mass[i] >= 0) || !std::isfinite(v.mass[i])) return "mass: negative or not finite";
        if (v.mass[i] == 0 && !v.locked[i]) return "mass: a free node has none";
    }
    return nullptr;
}

const char* tet_problem(const BundleView& v) {
    for (std::size_t t = 0; t < v.tets.size(); ++t) {
        for (const Index node : v.tets[t]) {
            if (node >= v.rest_positions.size()) return "tets: a corner is not a node";
        }
        if (v.material[t] >= v.materials.size()) return "material: not in the table";
        if (!(v.volume[t] > 0) || !std::isfinite(v.volume[t])) return "volume: not positive";
        if (!(v.stiffness_scale[t] > 0) || !std::isfinite(v.stiffness_scale[t])) return "stiffness_scale: not positive";
        for (const float value : v.inverse_rest[t]) {
            if (!std::isfinite(value)) return "inverse_rest: not finite";
        }
    }
    return nullptr;
}

}

const char* first_problem(const BundleView& view) {
    for (const auto check : {size_problem, material_problem, node_problem, tet_problem, row_problem, edge_problem}) {
        if (const char* problem = check(view)) return problem;
    }
    return nullptr;
}

}
