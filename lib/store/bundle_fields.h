// SPDX-License-Identifier: MIT
// Which array of a bundle is which dataset, said once for writing and reading. Paths are relative to /bundle; FORMAT.md
// lists the same names with their meaning.
#pragma once
#include <string>

#include "bundle/bundle.h"

namespace crumple::store {

// Archive offers rows(path, vector), value(path, element), texts(path, vector of strings) and text(path, string).
template <class Archive, class B>
void visit_mesh(Archive& archive, B& b) {
    archive.rows("rest_positions", b.rest_positions);
    archive.rows("mass", b.mass);
    archive.rows("locked", b.locked);
    archive.rows("node_to_mesh", b.node_to_mesh);
    archive.rows("mesh_to_node", b.mesh_to_node);
    archive.rows("locked_positions", b.locked_positions);
    archive.value("solver_tet_count", b.solver_tet_count);
    archive.rows("tets", b.tets);
    archive.rows("inverse_rest", b.inverse_rest);
    archive.rows("volume", b.volume);
    archive.rows("stiffness_scale", b.stiffness_scale);
    archive.rows("material", b.material);
    archive.rows("region", b.region);
    archive.texts("regions", b.regions);
}

template <class Archive, class B>
void visit_matrix(Archive& archive, B& b) {
    archive.rows("row_start", b.row_start);
    archive.rows("column", b.column);
    archive.rows("diagonal", b.diagonal);
    archive.rows("element_slots", b.element_slots);
    archive.rows("edges", b.edges);
    archive.rows("edge_slots", b.edge_slots);
    archive.rows("edge_start", b.edge_start);
    archive.rows("edge_tet", b.edge_tet);
    archive.rows("edge_corners", b.edge_corners);
}

template <class Archive, class Visual>
void visit_visual(Archive& archive, const std::string& group, Visual& visual) {
    archive.rows(group + "/tet", visual.tet);
    archive.rows(group + "/barycentric", visual.barycentric);
    archive.rows(group + "/inside", visual.inside);
    archive.rows(group + "/distance", visual.distance);
    archive.rows(group + "/tet_start", visual.tet_start);
    archive.rows(group + "/vertices_by_tet", visual.vertices_by_tet);
}

template <class Archive, class Sensor>
void visit_sensor(Archive& archive, const std::string& group, Sensor& sensor) {
    archive.rows(group + "/node", sensor.node);
    archive.rows(group + "/weight", sensor.weight);
    archive.value(group + "/rest_origin", sensor.rest_origin);
    archive.value(group + "/rest_axes", sensor.rest_axes);
}

template <class Archive, class Provenance>
void visit_provenance(Archive& archive, Provenance& provenance) {
    archive.text("provenance/tool_version", provenance.tool_version);
    archive.text("provenance/recipe", provenance.recipe);
}

}
