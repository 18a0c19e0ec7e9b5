// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/crowded.h"

#include <algorithm>

#include "finish/node_operations.h"
#include "finish/surface_operations.h"

namespace crumple::finish {

namespace {

constexpr double hopeless_shape = 1e-3;

struct Near {
    double distance_2;
    Index node;
};

// The nodes that crowd this one, nearest first, ties by number.
std::vector<Near> crowding_nodes(const WorkMesh& mesh, Index node, const std::vector<Index>& star) {
    std::vector<Near> others;
    double longest_2 = 0;
    for (const Index t : star) {
        for (const Index v : mesh.complex.corners(t)) {
            if (v == node) continue;
            const Vec3 along = mesh.at(v) - mesh.at(node);
            others.push_back({dot(along, along), v});
            longest_2 = std::max(longest_2, dot(along, along));
        }
    }
    std::erase_if(others, [&](const Near& n) { return n.distance_2 > crowded_share * crowded_share * longest_2; });
    std::sort(others.begin(), others.end(), [](const Near& a, const Near& b) {
        return a.distance_2 != b.distance_2 ? a.distance_2 < b.distance_2 : a.node < b.node;
    });
    const auto same = [](const Near& a, const Near& b) { return a.node == b.node; };
    others.erase(std::unique(others.begin(), others.end(), same), others.end());
    return others;
}

bool merge(WorkMesh& mesh, const SurfaceGuard& guard, Index node, std::vector<Index>& star, Exchange& exchange) {
    mesh.complex.star_of(node, star);
    const double least = least_shape(mesh, star);
    const double floor = least < hopeless_shape ? 0 : 0.99 * least;
    for (const Near& other : crowding_nodes(mesh, node, star)) {
        const bool is_planned = mesh.is_free[node]
                                    ? plan_contraction(mesh, node, star, other.node, floor, exchange)
                                    : plan_surface_operations(mesh, guard, node, star, other.node, floor, exchange);
        if (!is_planned) continue;
        (void)apply(mesh, exchange);
        return true;
    }
    return false;
}

}

std::uint64_t merge_crowded_nodes(WorkMesh& mesh, const SurfaceGuard& guard, const Context& context) {
    std::uint64_t merged = 0;
    std::vector<Index> star;
    Exchange exchange;
    for (bool has_merged = true; has_merged;) {
        context.stop_if_cancelled();
        has_merged = false;
        for (Index v = 0; v < mesh.complex.positions().size(); ++v) {
            if (!(mesh.is_free[v] || mesh.is_surplus[v]) || mesh.complex.tet_at(v) == none) continue;
            if (!merge(mesh, guard, v, star, exchange)) continue;
            has_merged = true;
            ++merged;
        }
    }
    return merged;
}

}
