// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "core/parallel_for.h"
#include "quality/element_stiffness.h"
#include "quality/quality.h"

namespace crumple::quality {

namespace {

constexpr std::size_t chunk_size = 1024;

// The value that a share of the values lies at or below; reorders them.
double percentile(std::vector<double>& values, double share) {
    if (values.empty()) return 0;
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

struct Measured {
    std::vector<TetMeasures> shapes;          // T
    std::vector<ElementStiffness> stiffness;  // T
};

Measured measure_all(std::span<const Vec3> positions, std::span<const Tet> tets, const Context& context) {
    Measured measured{std::vector<TetMeasures>(tets.size()), std::vector<ElementStiffness>(tets.size())};
    parallel_for(context, tets.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const auto& [a, b, c, d] = tets[t];
            measured.shapes[t] = measure_tet(positions[a], positions[b], positions[c], positions[d]);
            measured.stiffness[t] = measure_stiffness(positions[a], positions[b], positions[c], positions[d]);
        }
    });
    return measured;
}

template <class Items, class Member>
std::vector<double> column(const Items& items, Member member) {
    std::vector<double> values;
    values.reserve(items.size());
    for (const auto& item : items) values.push_back(item.*member);
    return values;
}

std::uint32_t count_used_nodes(std::size_t node_count, std::span<const Tet> tets) {
    std::vector<std::uint8_t> used(node_count);
    for (const Tet& tet : tets) {
        for (const Index node : tet) used[node] = 1;
    }
    return static_cast<std::uint32_t>(std::count(used.begin(), used.end(), std::uint8_t{1}));
}

std::uint32_t count_below_10_deg(std::span<const AngleKey> keys) {
    return static_cast<std::uint32_t>(
        std::count_if(keys.begin(), keys.end(), [](AngleKey k) { return k < key_of_10_deg; }));
}

void fill_angles(Summary& summary, const std::vector<TetMeasures>& shapes) {
    std::vector<AngleKey> least = column(shapes, &TetMeasures::min_dihedral);
    summary.below_10_deg = count_below_10_deg(least);
    summary.min_dihedral_deg = degrees_of(percentile(least, 0));
    summary.p1_dihedral_deg = degrees_of(percentile(least, 0.01));
    summary.p5_dihedral_deg = degrees_of(percentile(least, 0.05));
    summary.median_dihedral_deg = degrees_of(percentile(least, 0.5));
    std::vector<AngleKey> largest = column(shapes, &TetMeasures::max_dihedral);
    summary.max_dihedral_deg = degrees_of(percentile(largest, 1));
}

void fill_shapes(Summary& summary, const std::vector<TetMeasures>& shapes) {
    double shortest_2 = shapes.front().shortest_edge_2;
    double longest_2 = 0;
    summary.volume_lrms3_min = shapes.front().volume_lrms3;
    for (const TetMeasures& shape : shapes) {
        summary.volume += shape.volume;
        if (!(shape.volume > 0)) ++summary.inverted;
        shortest_2 = std::min(shortest_2, shape.shortest_edge_2);
        longest_2 = std::max(longest_2, shape.longest_edge_2);
        summary.volume_lrms3_min = std::min(summary.volume_lrms3_min, shape.volume_lrms3);
    }
    summary.edge_ratio = shortest_2 > 0 ? std::sqrt(longest_2 / shortest_2) : 0;
    std::vector<double> ratios = column(shapes, &TetMeasures::radius_ratio);
    summary.radius_ratio_min = percentile(ratios, 0);
    summary.radius_ratio_p5 = percentile(ratios, 0.05);
}

void fill_stiffness(Summary& summary, const std::vector<ElementStiffness>& stiffness) {
    std::vector<double> steps = column(stiffness, &ElementStiffness::step);
    std::vector<double> largest = column(stiffness, &ElementStiffness::largest);
    summary.element_step_m = percentile(steps, 0);
    const double regular = summary.volume > 0 ? regular_step(summary.volume / summary.tets) : 0;
    summary.element_step_ratio = regular > 0 ? summary.element_step_m / regular : 0;
    const double median = percentile(largest, 0.5);
    summary.stiffness_ratio = median > 0 ? percentile(largest, 1) / median : 0;
}

std::vector<AngleKey> min_dihedrals(std::span<const Vec3> positions, std::span<const Tet> tets,
                                    const Context& context) {
    std::vector<AngleKey> keys(tets.size());
    parallel_for(context, tets.size(), chunk_size, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const auto& [a, b, c, d] = tets[t];
            keys[t] = min_dihedral_key(positions[a], positions[b], positions[c], positions[d]);
        }
    });
    return keys;
}

}

Summary summarize(std::span<const Vec3> positions, std::span<const Tet> tets, const Context& context) {
    Summary summary;
    summary.tets = static_cast<std::uint32_t>(tets.size());
    if (tets.empty()) return summary;
    summary.nodes = count_used_nodes(positions.size(), tets);
    const Measured measured = measure_all(positions, tets, context);
    fill_angles(summary, measured.shapes);
    fill_shapes(summary, measured.shapes);
    fill_stiffness(summary, measured.stiffness);
    return summary;
}

Summary summarize(const TetMesh& mesh, const Context& context) { return summarize(mesh.positions, mesh.tets, context); }

Score score_of(std::span<const Vec3> positions, std::span<const Tet> tets, const Context& context) {
    std::vector<AngleKey> keys = min_dihedrals(positions, tets, context);
    return {count_below_10_deg(keys), percentile(keys, 0.01), percentile(keys, 0.05), percentile(keys, 0.5)};
}

bool is_better(const Score& a, const Score& b) {
    if (a.below_10_deg != b.below_10_deg) return a.below_10_deg < b.below_10_deg;
    return a.p1_dihedral > b.p1_dihedral;
}

}
