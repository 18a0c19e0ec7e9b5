// SPDX-License-Identifier: GPL-3.0-or-later
#include "bake/bake_bindings.h"

#include <numeric>

namespace crumple::bake {
namespace {

void bake_vertex(const VisualBinding& binding, std::size_t v, const TetOrder& order,
                 const std::vector<Index>& bundle_tet, BundleVisual& visual) {
    const Index tet = bundle_tet[binding.tet[v]];
    std::array<float, 4> weights{};
    for (std::size_t k = 0; k < 4; ++k)
        weights[k] = static_cast<float>(binding.barycentric[v][order.corners[tet][k]]) + 0.0f;
    visual.tet.push_back(tet);
    visual.barycentric.push_back(weights);
    visual.inside.push_back(binding.inside[v] ? 1 : 0);
    visual.distance.push_back(binding.inside[v] ? 0.0f : static_cast<float>(binding.distance[v]));
}

// Counting sort by tet: keeps vertices ascending within a tet.
void invert(std::size_t tet_count, BundleVisual& visual) {
    visual.tet_start.assign(tet_count + 1, 0);
    for (const Index tet : visual.tet) ++visual.tet_start[tet + 1];
    std::partial_sum(visual.tet_start.begin(), visual.tet_start.end(), visual.tet_start.begin());
    std::vector<Index> next(visual.tet_start.begin(), visual.tet_start.end() - 1);
    visual.vertices_by_tet.resize(visual.tet.size());
    for (Index v = 0; v < visual.tet.size(); ++v) visual.vertices_by_tet[next[visual.tet[v]]++] = v;
}

}

std::vector<BundleVisual> bake_bindings(const Bindings& bindings, const TetOrder& order) {
    std::vector<Index> bundle_tet(order.mesh_tet.size());
    for (Index t = 0; t < order.mesh_tet.size(); ++t) bundle_tet[order.mesh_tet[t]] = t;
    std::vector<BundleVisual> visuals;
    for (const VisualBinding& binding : bindings) {
        BundleVisual visual;
        visual.name = binding.name;
        for (std::size_t v = 0; v < binding.tet.size(); ++v) bake_vertex(binding, v, order, bundle_tet, visual);
        invert(order.mesh_tet.size(), visual);
        visuals.push_back(std::move(visual));
    }
    return visuals;
}

}
