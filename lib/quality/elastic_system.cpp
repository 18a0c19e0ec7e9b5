// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/elastic_system.h"

#include <algorithm>

#include "quality/element_stiffness.h"

namespace crumple::quality {

namespace {

// T: the mesh's nodes numbered without gaps, in their order.
std::vector<Tet> close_ranks(std::size_t node_count, std::span<const Tet> tets, std::vector<Index>& node) {
    std::vector<Index> row(node_count, none);
    for (const Tet& tet : tets) {
        for (const Index v : tet) row[v] = 0;
    }
    for (Index v = 0; v < node_count; ++v) {
        if (row[v] == none) continue;
        row[v] = static_cast<Index>(node.size());
        node.push_back(v);
    }
    std::vector<Tet> renumbered;
    renumbered.reserve(tets.size());
    for (const auto& [a, b, c, d] : tets) renumbered.push_back({row[a], row[b], row[c], row[d]});
    return renumbered;
}

// Which nodes share a tet, each pair both ways and every node with itself: counted, filled, then sorted row by row.
void find_pattern(std::span<const Tet> tets, ElasticSystem& system) {
    const std::size_t rows = system.size();
    std::vector<Index> start(rows + 1, 0);
    for (const Tet& tet : tets) {
        for (const Index v : tet) start[v + 1] += 4;
    }
    for (std::size_t row = 0; row < rows; ++row) start[row + 1] += start[row];
    std::vector<Index> met(start.back());
    std::vector<Index> end(start.begin(), start.end() - 1);
    for (const Tet& tet : tets) {
        for (const Index v : tet) {
            for (const Index w : tet) met[end[v]++] = w;
        }
    }
    system.row_start.assign(1, 0);
    for (std::size_t row = 0; row < rows; ++row) {
        const auto first = met.begin() + start[row];
        const auto last = met.begin() + start[row + 1];
        std::sort(first, last);
        system.column.insert(system.column.end(), first, std::unique(first, last));
        system.row_start.push_back(static_cast<Index>(system.column.size()));
    }
    system.stiffness.assign(system.column.size(), Block{});
}

Index find_block(const ElasticSystem& system, Index row, Index column) {
    const auto first = system.column.begin() + system.row_start[row];
    const auto last = system.column.begin() + system.row_start[row + 1];
    return static_cast<Index>(std::lower_bound(first, last, column) - system.column.begin());
}

struct Gradients {
    double volume;
    std::array<Vec3, 4> of;  // of the shape function of each corner
};

Gradients gradients_of(const std::array<Vec3, 4>& x) {
    const double six_volumes = dot(x[1] - x[0], cross(x[2] - x[0], x[3] - x[0]));
    Gradients gradients{six_volumes / 6, {}};
    for (int corner = 0; corner < 4; ++corner) {
        const auto& face = tet_face_corners[corner];
        gradients.of[corner] = cross(x[face[2]] - x[face[0]], x[face[1]] - x[face[0]]) / six_volumes;
    }
    return gradients;
}

// K_ij = V (lambda g_i g_j^T + mu g_j g_i^T + mu (g_i . g_j) I)
void add_block(Block& block, const Gradients& g, int i, int j) {
    const double along = lame_mu * dot(g.of[i], g.of[j]);
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
            const double value = lame_lambda * g.of[i][r] * g.of[j][c] + lame_mu * g.of[j][r] * g.of[i][c];
            block[3 * r + c] += g.volume * (r == c ? value + along : value);
        }
    }
}

}

ElasticSystem assemble(std::span<const Vec3> positions, std::span<const Tet> tets) {
    ElasticSystem system;
    const std::vector<Tet> rows = close_ranks(positions.size(), tets, system.node);
    system.mass.assign(system.size(), 0);
    find_pattern(rows, system);
    for (std::size_t t = 0; t < tets.size(); ++t) {
        std::array<Vec3, 4> corners;
        for (int i = 0; i < 4; ++i) corners[i] = positions[tets[t][i]];
        const Gradients gradients = gradients_of(corners);
        for (int i = 0; i < 4; ++i) {
            system.mass[rows[t][i]] += gradients.volume / 4;
            for (int j = 0; j < 4; ++j) {
                add_block(system.stiffness[find_block(system, rows[t][i], rows[t][j])], gradients, i, j);
            }
        }
    }
    return system;
}

void multiply(const ElasticSystem& system, std::span<const Vec3> x, std::span<Vec3> y) {
    for (std::size_t row = 0; row < system.size(); ++row) {
        Vec3 sum;
        for (Index at = system.row_start[row]; at < system.row_start[row + 1]; ++at) {
            const Block& k = system.stiffness[at];
            const Vec3& v = x[system.column[at]];
            sum.x += k[0] * v.x + k[1] * v.y + k[2] * v.z;
            sum.y += k[3] * v.x + k[4] * v.y + k[5] * v.z;
            sum.z += k[6] * v.x + k[7] * v.y + k[8] * v.z;
        }
        y[row] = sum;
    }
}

}
