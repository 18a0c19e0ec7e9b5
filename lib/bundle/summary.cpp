// SPDX-License-Identifier: MIT
#include "bundle/summary.h"

#include <algorithm>
#include <cmath>

namespace crumple {
namespace {

void count_nodes(const Bundle& b, BundleSummary& s) {
    s.nodes = b.rest_positions.size();
    if (b.rest_positions.empty()) return;
    const Vec3f first = b.rest_positions.front();
    s.box_low = s.box_high = {first.x, first.y, first.z};
    for (std::size_t node = 0; node < b.rest_positions.size(); ++node) {
        s.mass_kg += b.mass[node];
        s.locked_nodes += b.locked[node];
        if (b.mass[node] == 0) ++s.unused_locked_nodes;
        for (int axis = 0; axis < 3; ++axis) {
            s.box_low[axis] = std::min(s.box_low[axis], double{b.rest_positions[node][axis]});
            s.box_high[axis] = std::max(s.box_high[axis], double{b.rest_positions[node][axis]});
        }
    }
}

void count_tets(const Bundle& b, BundleSummary& s) {
    s.tets = b.tets.size();
    s.solver_tets = b.solver_tet_count;
    s.blocks = b.column.size();
    s.edges = b.edges.size();
    for (const auto& [i, j] : b.edges) s.bandwidth = std::max<std::uint64_t>(s.bandwidth, j - i);
    for (const Material& material : b.materials) s.materials.push_back({material.name});
    for (const std::string& region : b.regions) s.regions.push_back({region});
    for (std::size_t t = 0; t < b.tets.size(); ++t) {
        s.volume_m3 += b.volume[t];
        MaterialSummary& material = s.materials[b.material[t]];
        ++material.tets;
        material.mass_kg += b.volume[t] * b.materials[b.material[t]].density_kg_m3;
        ++s.regions[b.region[t]].tets;
        s.regions[b.region[t]].volume_m3 += b.volume[t];
    }
}

VisualSummary summarize(const BundleVisual& visual) {
    VisualSummary s{visual.name, visual.tet.size()};
    for (std::size_t v = 0; v < visual.tet.size(); ++v) {
        if (!visual.inside[v]) ++s.outside;
        s.max_distance = std::max(s.max_distance, double{visual.distance[v]});
        for (const float w : visual.barycentric[v]) s.max_abs_weight = std::max(s.max_abs_weight, std::fabs(double{w}));
    }
    return s;
}

}

BundleSummary summarize(const Bundle& bundle) {
    BundleSummary summary;
    count_nodes(bundle, summary);
    count_tets(bundle, summary);
    for (const BundleVisual& visual : bundle.visuals) summary.visuals.push_back(summarize(visual));
    for (const BundleSensor& sensor : bundle.sensors) {
        const Vec3f p = sensor.rest_origin;
        summary.sensors.push_back({sensor.name, sensor.node.size(), {p.x, p.y, p.z}});
    }
    return summary;
}

}
