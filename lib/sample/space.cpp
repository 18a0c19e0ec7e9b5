// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/space.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/watertight.h"

namespace crumple::sample {

namespace {

std::vector<Box> boxes_of(const std::vector<Vec3>& positions) {
    std::vector<Box> boxes;
    boxes.reserve(positions.size());
    for (const Vec3& p : positions) boxes.push_back({p, p});
    return boxes;
}

Box box_of_triangles(const Shell& shell) {
    Box box;
    for (const Triangle& triangle : shell.triangles) {
        for (const Index v : triangle) box.add(shell.positions[v]);
    }
    return box;
}

// Half a unit in the last place of the largest coordinate, on each of three axes.
double rounding_of(const Box& box) {
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        largest = std::max({largest, std::fabs(box.low[axis]), std::fabs(box.high[axis])});
    }
    return 1.8 * largest * 0x1p-24;
}

std::vector<std::uint8_t> fillable_components(const Shell& shell) {
    std::vector<std::uint8_t> fillable(shell.components.size());
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        for (const Index v : shell.triangles[f]) {
            const bool is_locked = v < shell.locked.size() && shell.locked[v] != 0;
            if (!is_locked) fillable[shell.component[f]] = 1;
        }
    }
    for (std::size_t c = 0; c < fillable.size(); ++c) {
        if (shell.components[c].role != Role::solid) fillable[c] = 0;
    }
    return fillable;
}

std::vector<double> mean_edge_lengths(const Shell& shell) {
    std::vector<double> sum(shell.positions.size());
    std::vector<double> edges(shell.positions.size());
    for (const Triangle& triangle : shell.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            const Index a = triangle[corner];
            const Index b = triangle[(corner + 1) % 3];
            const double along = length(shell.positions[b] - shell.positions[a]);
            for (const Index v : {a, b}) {
                sum[v] += along;
                edges[v] += along > 0 ? 1 : 0;
            }
        }
    }
    for (std::size_t v = 0; v < sum.size(); ++v) sum[v] = edges[v] > 0 ? sum[v] / edges[v] : 0;
    return sum;
}

}

Space::Space(const Shell& shell, std::vector<double> factor)
    : shell_(shell),
      interior_(shell),
      vertex_tree_(boxes_of(shell.positions)),
      box_(box_of_triangles(shell)),
      rounding_(rounding_of(box_)),
      is_watertight_(crumple::is_watertight(shell.triangles)),
      fillable_(fillable_components(shell)),
      sizes_(mean_edge_lengths(shell)),
      factors_(std::move(factor)),
      triangles_(shell.triangles.size()) {
    std::iota(triangles_.begin(), triangles_.end(), Index{0});
    faces_.reserve(shell.triangles.size());
    for (const auto& [a, b, c] : shell.triangles) {
        faces_.emplace_back(shell.positions[a], shell.positions[b], shell.positions[c]);
        balls_.emplace_back(shell.positions[a], shell.positions[b], shell.positions[c]);
    }
    for (std::size_t v = 0; v < sizes_.size(); ++v) {
        sizes_[v] *= factor_of(static_cast<Index>(v));
        if (sizes_[v] > 0) sized_vertices_.push_back(static_cast<Index>(v));
    }
}

bool Space::is_fillable(Vec3 p) const {
    const Index component = interior_.material_at(p);
    return component != none && fillable_[component] != 0;
}

double Space::distance_to_vertex(Vec3 p, double at_most) const {
    const auto distance_2 = [&](Index v) { return dot(shell_.positions[v] - p, shell_.positions[v] - p); };
    return std::sqrt(vertex_tree_.nearest(p, distance_2, {none, at_most * at_most}).distance_2);
}

}
