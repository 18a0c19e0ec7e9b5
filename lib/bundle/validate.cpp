// SPDX-License-Identifier: MIT
#include "bundle/validate.h"

#include <algorithm>
#include <cmath>

#include "bundle/validate_parts.h"

namespace crumple {

void Complaints::add(const char* code, const char* message, Index element, Vec3f position, std::string_view name) {
    auto finding = std::find_if(findings_.begin(), findings_.end(), [&](const Finding& f) { return f.code == code; });
    if (finding == findings_.end()) {
        findings_.push_back({code, Severity::error, message, 0, {}});
        finding = findings_.end() - 1;
    }
    count_one(*finding, {widen(position), element, std::string(name)});
}

namespace {

template <class Array>
void expect_size(const Array& array, std::size_t size, std::string_view name, Complaints& complaints) {
    if (array.size() != size) {
        complaints.add("BUNDLE_SIZE", "arrays that belong together differ in length; place names the array", none,
                       no_place, name);
    }
}

template <class Array>
void expect_below(const Array& indices, std::size_t limit, std::string_view name, Complaints& complaints) {
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] >= limit) {
            complaints.add("BUNDLE_INDEX", "an index points past the end; place names the array and its row",
                           static_cast<Index>(i), no_place, name);
        }
    }
}

template <class Rows>
void expect_rows_below(const Rows& rows, std::size_t limit, std::string_view name, Complaints& complaints) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (std::any_of(rows[i].begin(), rows[i].end(), [&](Index value) { return value >= limit; })) {
            complaints.add("BUNDLE_INDEX", "an index points past the end; place names the array and its row",
                           static_cast<Index>(i), no_place, name);
        }
    }
}

// Row starts 0 = s[0] <= s[1] <= ... = end.
void expect_starts(const std::vector<Index>& starts, std::size_t end, std::string_view name, Complaints& complaints) {
    if (starts.front() != 0 || starts.back() != end || !std::is_sorted(starts.begin(), starts.end())) {
        complaints.add("BUNDLE_INDEX", "row starts do not rise from 0 to the number of entries; place names the array",
                       none, no_place, name);
    }
}

bool is_finite(float x) { return std::isfinite(x); }
template <std::size_t K>
bool is_finite(const std::array<float, K>& row) {
    return std::all_of(row.begin(), row.end(), [](float x) { return std::isfinite(x); });
}

template <class Array>
void expect_finite(const Array& values, std::string_view name, Complaints& complaints) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!is_finite(values[i])) {
            complaints.add("BUNDLE_NUMBER", "a number is not finite; place names the array and its row",
                           static_cast<Index>(i), no_place, name);
        }
    }
}

void expect_flags(const std::vector<std::uint8_t>& flags, std::string_view name, Complaints& complaints) {
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (flags[i] > 1)
            complaints.add("BUNDLE_NUMBER", "a flag is not 0 or 1", static_cast<Index>(i), no_place, name);
    }
}

void check_table_sizes(const Bundle& b, Complaints& complaints) {
    const std::size_t tet_count = b.tets.size();
    for (const BundleVisual& visual : b.visuals) {
        const std::size_t vertex_count = visual.tet.size();
        expect_size(visual.barycentric, vertex_count, visual.name + "/barycentric", complaints);
        expect_size(visual.inside, vertex_count, visual.name + "/inside", complaints);
        expect_size(visual.distance, vertex_count, visual.name + "/distance", complaints);
        expect_size(visual.tet_start, tet_count + 1, visual.name + "/tet_start", complaints);
        expect_size(visual.vertices_by_tet, vertex_count, visual.name + "/vertices_by_tet", complaints);
    }
    for (const BundleSensor& sensor : b.sensors) {
        expect_size(sensor.weight, sensor.node.size(), sensor.name + "/weight", complaints);
        if (sensor.node.empty()) complaints.add("BUNDLE_SENSOR", "a sensor has no nodes", none, no_place, sensor.name);
    }
}

}

void check_sizes(const Bundle& b, Complaints& complaints) {
    const std::size_t node_count = b.rest_positions.size();
    const std::size_t tet_count = b.tets.size();
    const std::size_t solver_tet_count = b.solver_tet_count;
    if (tet_count == 0 || node_count == 0) complaints.add("BUNDLE_EMPTY", "the bundle has no tets");
    if (tet_count >= none || node_count >= none || solver_tet_count > tet_count) {
        complaints.add("BUNDLE_SIZE", "more tets or nodes than indices allow, or more solver tets than tets");
    }
    expect_size(b.mass, node_count, "mass", complaints);
    expect_size(b.locked, node_count, "locked", complaints);
    expect_size(b.node_to_mesh, node_count, "node_to_mesh", complaints);
    expect_size(b.inverse_rest, tet_count, "inverse_rest", complaints);
    expect_size(b.volume, tet_count, "volume", complaints);
    expect_size(b.stiffness_scale, tet_count, "stiffness_scale", complaints);
    expect_size(b.material, tet_count, "material", complaints);
    expect_size(b.region, tet_count, "region", complaints);
    expect_size(b.row_start, node_count + 1, "row_start", complaints);
    expect_size(b.diagonal, node_count, "diagonal", complaints);
    expect_size(b.element_slots, solver_tet_count, "element_slots", complaints);
    expect_size(b.edge_slots, b.edges.size(), "edge_slots", complaints);
    expect_size(b.edge_start, b.edges.size() + 1, "edge_start", complaints);
    expect_size(b.edge_tet, 6 * solver_tet_count, "edge_tet", complaints);
    expect_size(b.edge_corners, 6 * solver_tet_count, "edge_corners", complaints);
    check_table_sizes(b, complaints);
}

void check_indices(const Bundle& b, Complaints& complaints) {
    const std::size_t node_count = b.rest_positions.size();
    expect_below(b.node_to_mesh, b.mesh_to_node.size(), "node_to_mesh", complaints);
    expect_rows_below(b.tets, node_count, "tets", complaints);
    expect_below(b.material, b.materials.size(), "material", complaints);
    expect_below(b.region, b.regions.size(), "region", complaints);
    expect_starts(b.row_start, b.column.size(), "row_start", complaints);
    expect_below(b.column, node_count, "column", complaints);
    expect_below(b.diagonal, b.column.size(), "diagonal", complaints);
    expect_rows_below(b.element_slots, b.column.size(), "element_slots", complaints);
    expect_rows_below(b.edges, node_count, "edges", complaints);
    expect_rows_below(b.edge_slots, b.column.size(), "edge_slots", complaints);
    expect_starts(b.edge_start, b.edge_tet.size(), "edge_start", complaints);
    expect_below(b.edge_tet, b.solver_tet_count, "edge_tet", complaints);
    expect_rows_below(b.edge_corners, 4, "edge_corners", complaints);
    for (const BundleVisual& visual : b.visuals) {
        expect_below(visual.tet, b.tets.size(), visual.name + "/tet", complaints);
        expect_starts(visual.tet_start, visual.tet.size(), visual.name + "/tet_start", complaints);
        expect_below(visual.vertices_by_tet, visual.tet.size(), visual.name + "/vertices_by_tet", complaints);
    }
    for (const BundleSensor& sensor : b.sensors)
        expect_below(sensor.node, node_count, sensor.name + "/node", complaints);
}

void check_numbers(const Bundle& b, Complaints& complaints) {
    expect_finite(b.rest_positions, "rest_positions", complaints);
    expect_finite(b.mass, "mass", complaints);
    expect_flags(b.locked, "locked", complaints);
    expect_finite(b.locked_positions, "locked_positions", complaints);
    expect_finite(b.inverse_rest, "inverse_rest", complaints);
    expect_finite(b.volume, "volume", complaints);
    expect_finite(b.stiffness_scale, "stiffness_scale", complaints);
    for (const BundleVisual& visual : b.visuals) {
        expect_finite(visual.barycentric, visual.name + "/barycentric", complaints);
        expect_flags(visual.inside, visual.name + "/inside", complaints);
        expect_finite(visual.distance, visual.name + "/distance", complaints);
    }
    for (const BundleSensor& sensor : b.sensors) {
        expect_finite(sensor.weight, sensor.name + "/weight", complaints);
        if (!is_finite(sensor.rest_origin) || !is_finite(sensor.rest_axes)) {
            complaints.add("BUNDLE_NUMBER", "a number is not finite; place names the array", none, no_place,
                           sensor.name);
        }
    }
    for (const Material& material : b.materials) {
        if (!first_field_out_of_range(material).empty()) {
            complaints.add("BUNDLE_MATERIAL", "a material has a number out of range; place names it", none, no_place,
                           material.name);
        }
    }
}

void check_node_order(const Bundle& b, Complaints& complaints) {
    for (Index node = 0; node < b.node_to_mesh.size(); ++node) {
        if (b.mesh_to_node[b.node_to_mesh[node]] != node) {
            complaints.add("BUNDLE_NODE_ORDER", "node_to_mesh and mesh_to_node disagree; place is the node", node,
                           b.rest_positions[node]);
        }
    }
    const auto kept = b.mesh_to_node.size() -
                      static_cast<std::size_t>(std::count(b.mesh_to_node.begin(), b.mesh_to_node.end(), none));
    if (kept != b.node_to_mesh.size()) {
        complaints.add("BUNDLE_NODE_ORDER", "mesh_to_node keeps another number of nodes than the bundle has");
    }
}

void check_locks(const Bundle& b, Complaints& complaints) {
    std::vector<Vec3f> locked;
    for (std::size_t node = 0; node < b.locked.size(); ++node) {
        if (b.locked[node]) locked.push_back(b.rest_positions[node]);
    }
    std::sort(locked.begin(), locked.end(), lexicographic_less<float>);
    const auto& painted = b.locked_positions;
    for (std::size_t i = 1; i < painted.size(); ++i) {
        if (!lexicographic_less(painted[i - 1], painted[i])) {
            complaints.add("BUNDLE_LOCK_ORDER", "locked_positions are not in strictly rising order",
                           static_cast<Index>(i), painted[i]);
        }
    }
    if (!std::is_sorted(painted.begin(), painted.end(), lexicographic_less<float>)) return;
    for (const Vec3f p : painted) {
        if (!std::binary_search(locked.begin(), locked.end(), p, lexicographic_less<float>)) {
            complaints.add("BUNDLE_LOCK_MISSING", "a painted lock has no locked node at its position", none, p);
        }
    }
    for (const Vec3f p : locked) {
        if (!std::binary_search(painted.begin(), painted.end(), p, lexicographic_less<float>)) {
            complaints.add("BUNDLE_LOCK_UNLISTED", "a locked node is not among the painted positions", none, p);
        }
    }
}

std::vector<Finding> validate(const Bundle& bundle) {
    Complaints complaints;
    for (const auto check : {check_sizes, check_indices, check_numbers}) {
        check(bundle, complaints);
        if (!complaints.empty()) return complaints.take();
    }
    for (const auto check : {check_node_order, check_locks, check_tet_geometry, check_tet_order, check_faces,
                             check_masses, check_matrix, check_edges, check_visuals, check_sensors, check_names}) {
        check(bundle, complaints);
    }
    return complaints.take();
}

}
