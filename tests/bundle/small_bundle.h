// SPDX-License-Identifier: MIT
// A bundle small enough to read: a cube of five tets on top of another, the lower one locked.
#pragma once
#include <algorithm>

#include "bundle/bundle.h"
#include "bundle/exact_volume.h"
#include "bundle/matrix_pattern.h"

namespace crumple::test {

// Five tets fill a unit cube whose corners are node[x + 2 y + 4 z]; odd cubes are mirrored so that faces meet.
inline std::vector<Tet> cube_tets(const std::array<Index, 8>& n, bool is_odd) {
    if (is_odd) {
        return {{n[1], n[3], n[0], n[5]},
                {n[2], n[0], n[3], n[6]},
                {n[4], n[0], n[6], n[5]},
                {n[7], n[3], n[5], n[6]},
                {n[0], n[3], n[6], n[5]}};
    }
    return {{n[0], n[1], n[2], n[4]},
            {n[3], n[2], n[1], n[7]},
            {n[5], n[4], n[7], n[1]},
            {n[6], n[2], n[7], n[4]},
            {n[1], n[7], n[2], n[4]}};
}

inline void fill_rest_state(Bundle& b) {
    const std::size_t tet_count = b.tets.size();
    std::vector<double> mass(b.rest_positions.size(), 0.0);
    b.inverse_rest.assign(tet_count, {});
    b.volume.assign(tet_count, 0);
    for (std::size_t t = 0; t < tet_count; ++t) {
        const auto corner = [&](std::size_t k) { return b.rest_positions[b.tets[t][k]]; };
        const double volume = six_volumes(corner(0), corner(1), corner(2), corner(3)) / 6;
        const auto inverse = inverse_rest_matrix(corner(0), corner(1), corner(2), corner(3));
        for (std::size_t i = 0; i < 9; ++i) b.inverse_rest[t][i] = static_cast<float>(inverse[i]);
        b.volume[t] = static_cast<float>(volume);
        for (const Index node : b.tets[t]) mass[node] += b.materials[b.material[t]].density_kg_m3 * volume / 4;
    }
    b.mass.assign(mass.begin(), mass.end());
}

inline void fill_locked_positions(Bundle& b) {
    b.locked_positions.clear();
    for (std::size_t node = 0; node < b.locked.size(); ++node) {
        if (b.locked[node]) b.locked_positions.push_back(b.rest_positions[node]);
    }
    std::sort(b.locked_positions.begin(), b.locked_positions.end(), lexicographic_less<float>);
}

// One visual vertex in the middle of each tet and one above the top, one sensor over all free nodes.
inline void add_visual_and_sensor(Bundle& b) {
    BundleVisual visual;
    visual.name = "paint";
    for (Index t = 0; t < b.tets.size(); ++t) {
        visual.tet.push_back(t);
        visual.barycentric.push_back({0.25f, 0.25f, 0.25f, 0.25f});
        visual.inside.push_back(1);
        visual.distance.push_back(0);
    }
    visual.tet.push_back(0);
    visual.barycentric.push_back({1.5f, -0.5f, 0, 0});
    visual.inside.push_back(0);
    visual.distance.push_back(0.5f);
    visual.tet_start = {0};
    for (Index t = 0; t < b.tets.size(); ++t) {
        visual.vertices_by_tet.push_back(t);
        if (t == 0) visual.vertices_by_tet.push_back(static_cast<Index>(b.tets.size()));
        visual.tet_start.push_back(static_cast<Index>(visual.vertices_by_tet.size()));
    }
    b.visuals.push_back(visual);

    BundleSensor sensor{"roof", {}, {}, {}, {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    for (Index node = 0; node < b.locked.size(); ++node) {
        if (!b.locked[node]) sensor.node.push_back(node);
    }
    sensor.weight.assign(sensor.node.size(), 1.0f / static_cast<float>(sensor.node.size()));
    for (const Index node : sensor.node) sensor.rest_origin += b.rest_positions[node] * sensor.weight[0];
    b.sensors.push_back(sensor);
}

// A tower of `height` cubes; the corners at y <= 1 are locked, so the lowest cube's five tets are all locked.
inline Bundle small_bundle(Index height = 2) {
    Bundle b;
    for (Index y = 0; y <= height; ++y) {
        for (Index corner = 0; corner < 4; ++corner) {
            b.rest_positions.push_back(
                {static_cast<float>(corner % 2), static_cast<float>(y), static_cast<float>(corner / 2)});
            b.locked.push_back(y <= 1 ? 1 : 0);
        }
    }
    const auto node = [](Index x, Index y, Index z) { return 4 * y + x + 2 * z; };
    for (Index y = height; y-- > 0;) {  // the locked cube last
        const auto tets = cube_tets({node(0, y, 0), node(1, y, 0), node(0, y + 1, 0), node(1, y + 1, 0), node(0, y, 1),
                                     node(1, y, 1), node(0, y + 1, 1), node(1, y + 1, 1)},
                                    y % 2 == 1);
        b.tets.insert(b.tets.end(), tets.begin(), tets.end());
    }
    b.solver_tet_count = static_cast<std::uint32_t>(b.tets.size() - 5);
    for (Index n = 0; n < b.locked.size(); ++n) {
        b.node_to_mesh.push_back(n + 1);
        b.mesh_to_node.push_back(n == 0 ? none : n - 1);
    }
    b.mesh_to_node.push_back(static_cast<Index>(b.locked.size()) - 1);
    b.stiffness_scale.assign(b.tets.size(), 1.0f);
    b.material.assign(b.tets.size(), 0);
    b.region.assign(b.tets.size(), 0);
    b.materials = {Material{}};
    b.regions = {"tower"};
    fill_rest_state(b);
    fill_locked_positions(b);
    build_matrix_pattern(b);
    add_visual_and_sensor(b);
    b.provenance = {"0.1.0", R"({"stages": []})", {{"bake", "1"}}, {{"shell", std::string(64, 'a')}}};
    return b;
}

}
