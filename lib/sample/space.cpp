// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/space.h"

#include <algorithm>
#include <cmath>

namespace crumple::sample {

namespace {

Box box_of(Vec3 p) { return {p, p}; }

std::vector<Box> boxes_of(const std::vector<Vec3>& positions) {
    std::vector<Box> boxes;
    boxes.reserve(positions.size());
    for (const Vec3& p : positions) boxes.push_back(box_of(p));
    return boxes;
}

// 0 for a vertex that no edge of any length meets.
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

// Every edge is run through as often one way as the other. Then the winding number is a whole number everywhere off the
// surface and changes only across it.
bool has_no_boundary(const Shell& shell) {
    std::vector<Edge> forward;
    std::vector<Edge> backward;
    for (const Triangle& triangle : shell.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            const Index a = triangle[corner];
            const Index b = triangle[(corner + 1) % 3];
            if (a < b) forward.push_back({a, b});
            if (b < a) backward.push_back({b, a});
        }
    }
    std::sort(forward.begin(), forward.end());
    std::sort(backward.begin(), backward.end());
    return forward == backward;
}

std::vector<std::uint8_t> fillable_components(const Shell& shell) {
    std::vector<std::uint8_t> has_free_vertex(shell.components.size());
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        for (const Index v : shell.triangles[f]) {
            const bool is_locked = v < shell.locked.size() && shell.locked[v] != 0;
            if (!is_locked) has_free_vertex[shell.component[f]] = 1;
        }
    }
    for (std::size_t c = 0; c < shell.components.size(); ++c) {
        if (shell.components[c].role != Role::solid) has_free_vertex[c] = 0;
    }
    return has_free_vertex;
}

}

SizingField::SizingField(const Shell& shell, const std::vector<double>& factor) {
    std::vector<Vec3> positions;
    std::vector<double> sizes = mean_edge_lengths(shell);
    for (std::size_t v = 0; v < sizes.size(); ++v) {
        if (!(sizes[v] > 0)) continue;
        sizes[positions.size()] = factor.empty() ? sizes[v] : sizes[v] * factor[v];
        positions.push_back(shell.positions[v]);
    }
    sizes.resize(positions.size());
    build(std::move(positions), std::move(sizes));
    drop_vertices_that_never_win();
}

void SizingField::build(std::vector<Vec3> positions, std::vector<double> sizes) {
    positions_ = std::move(positions);
    sizes_ = std::move(sizes);
    tree_ = build_box_tree(boxes_of(positions_));
    least_.assign(tree_.nodes.size(), std::numeric_limits<double>::infinity());
    for (std::size_t n = 0; n < tree_.nodes.size(); ++n) {
        const BoxTree::Node& node = tree_.nodes[n];
        for (Index i = node.first; i < node.first + node.count; ++i) {
            least_[n] = std::fmin(least_[n], sizes_[tree_.items[i]]);
        }
    }
}

// Where another vertex gives a smaller size at v than L_v does, it does so everywhere (triangle inequality).
void SizingField::drop_vertices_that_never_win() {
    std::vector<Vec3> positions;
    std::vector<double> sizes;
    for (std::size_t v = 0; v < positions_.size(); ++v) {
        if (at(positions_[v]) < sizes_[v]) continue;
        positions.push_back(positions_[v]);
        sizes.push_back(sizes_[v]);
    }
    build(std::move(positions), std::move(sizes));
}

double SizingField::at(Vec3 p, double at_most) const {
    const auto bound = [&](Index node) {
        return least_[node] + size_growth * std::sqrt(distance_2(tree_.nodes[node].box, p));
    };
    const auto size = [&](Index v) { return sizes_[v] + size_growth * length(p - positions_[v]); };
    return least_cost(tree_, bound, size, at_most);
}

Space::Space(const Shell& shell)
    : shell_(shell),
      interior_(shell),
      fillable_(fillable_components(shell)),
      vertices_(build_box_tree(boxes_of(shell.positions))),
      is_watertight_(has_no_boundary(shell)) {
    std::vector<Box> boxes;
    for (const Triangle& triangle : shell.triangles) {
        Box box;
        for (const Index v : triangle) box.add(shell.positions[v]);
        boxes.push_back(box);
        box_.add(box.low);
        box_.add(box.high);
    }
    triangles_ = build_box_tree(boxes);
}

double Space::distance_to_surface(Vec3 p, double at_most) const {
    const auto bound = [&](Index node) { return distance_2(triangles_.nodes[node].box, p); };
    const auto cost = [&](Index f) {
        const auto& [a, b, c] = shell_.triangles[f];
        const Vec3 to = closest_point_on_triangle(shell_.positions[a], shell_.positions[b], shell_.positions[c], p) - p;
        return dot(to, to);
    };
    return std::sqrt(least_cost(triangles_, bound, cost, at_most * at_most));
}

double Space::distance_to_vertex(Vec3 p, double at_most) const {
    const auto bound = [&](Index node) { return distance_2(vertices_.nodes[node].box, p); };
    const auto cost = [&](Index v) { return dot(shell_.positions[v] - p, shell_.positions[v] - p); };
    return std::sqrt(least_cost(vertices_, bound, cost, at_most * at_most));
}

bool Space::is_fillable(Vec3 p) const {
    const Index component = interior_.material_at(p);
    return component != none && fillable_[component] != 0;
}

}
