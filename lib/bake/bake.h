// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the tet mesh and its bindings into the float arrays a game loads. The one place where double becomes float.
// No lock gets lost: every painted position is a locked node of the bundle, or bake refuses.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "bundle/bundle.h"
#include "bundle/summary.h"
#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "material/material.h"
#include "mesh/asset.h"
#include "mesh/bindings.h"
#include "mesh/tet_mesh.h"

namespace crumple::bake {

inline constexpr int version = 1;

// Small distances |i - j| along edges keep the solver's reads near each other.
enum class NodeOrder {
    rcm,   // reverse Cuthill-McKee
    axis,  // along the longest axis of the bounding box
    mesh,  // as the tet mesh has them
};
inline constexpr EnumName<NodeOrder> node_order_names[] = {
    {NodeOrder::rcm, "rcm"}, {NodeOrder::axis, "axis"}, {NodeOrder::mesh, "mesh"}};
constexpr std::span<const EnumName<NodeOrder>> enum_names(NodeOrder) { return node_order_names; }

// How a sensor's nodes are chosen.
enum class SensorBy {
    box,        // every node inside
    component,  // the component's own vertices and the nodes of the tets inside it
    color,      // the shell vertices painted so
};
inline constexpr EnumName<SensorBy> sensor_by_names[] = {
    {SensorBy::box, "box"}, {SensorBy::component, "component"}, {SensorBy::color, "color"}};
constexpr std::span<const EnumName<SensorBy>> enum_names(SensorBy) { return sensor_by_names; }

struct SensorParams {
    std::string name;
    SensorBy by = SensorBy::box;
    Vec3 box_low;
    Vec3 box_high;
    std::string component;
    Vec3 color;
    double color_tolerance = 0.01;
};

// Steel is the body of a car; an engine block only has to be heavy and not to bend.
[[nodiscard]] std::vector<Material> default_materials();

struct Params {
    NodeOrder node_order = NodeOrder::rcm;
    std::vector<Material> materials = default_materials();
    // Which of them a shell component is made of: the first of these that names it decides.
    std::map<std::string, std::string> material_by_component;
    std::map<std::string, std::string> material_by_source;
    std::map<std::string, std::string> material_by_role = {{"solid", "steel"}, {"rigid", "engine"}};
    std::map<std::string, double> stiffness_by_component;
    std::vector<SensorParams> sensors;
    double step_s = 1.0 / 60;  // the game's; changes nothing, but nodes too light for it are warned of
};

// Throws Error(usage) for a material table that is empty or has a name twice, a map that names no role or a material
// that is not in the table, a factor or a step out of range, a sensor without a name of its own.
void check_params(const Params& params);

struct Report {
    std::uint64_t mesh_nodes = 0;
    std::uint64_t dropped_interior = 0;
    std::uint64_t dropped_shell = 0;
    std::uint64_t bandwidth_before = 0;
    double max_inverse_error = 0;
    BundleSummary bundle;
    std::vector<Finding> findings;
};

struct Result {
    Bundle bundle;  // provenance is left to the caller, who knows recipe and inputs
    Report report;
};

// The same bundle for any order of the mesh's nodes and tets, apart from node_to_mesh, mesh_to_node and region numbers.
// Throws Error(usage) as check_params does, Error(bad_input) when the inputs do not fit
// each other, a painted lock has no node, or a tet is too small for float.
[[nodiscard]] Result bake_bundle(const Asset& asset, const TetMesh& mesh, const Bindings& bindings,
                                 const Params& params = {}, const Context& context = {});

template <class Visitor, FieldsOf<SensorParams> P>
void describe(Visitor& visit, P& p) {
    visit.field("name", p.name, "what the game calls it");
    visit.field("by", p.by, "how its nodes are chosen");
    visit.field("box_low", p.box_low, "lowest corner of the box, metres");
    visit.field("box_high", p.box_high, "highest corner of the box, metres");
    visit.field("component", p.component, "name of the shell component");
    visit.field("color", p.color, "linear red, green and blue of the shell vertices");
    visit.field("color_tolerance", p.color_tolerance, Range{0, 1}, "largest difference of a channel");
}

template <class Visitor, FieldsOf<Params> P>
void describe(Visitor& visit, P& p) {
    visit.field("node_order", p.node_order, "how nodes are renumbered");
    visit.field("materials", p.materials, "the material table");
    visit.field("material_by_component", p.material_by_component, "shell component -> material; decides first");
    visit.field("material_by_source", p.material_by_source, "material of the shell's file -> material; decides second");
    visit.field("material_by_role", p.material_by_role, "role of a component -> material; decides last");
    visit.field("stiffness_by_component", p.stiffness_by_component, Range{1e-6, 1e6},
                "shell component -> factor on Young's modulus");
    visit.field("sensors", p.sensors, "named rigid frames carried by clusters of nodes");
    visit.field("step_s", p.step_s, Range{1e-6, 1}, "the game's time step: what is too stiff for it is warned of");
}

template <class Visitor, FieldsOf<Report> R>
void describe(Visitor& visit, R& r) {
    visit.field("mesh_nodes", r.mesh_nodes, "nodes of the tet mesh");
    visit.field("dropped_interior", r.dropped_interior, "interior nodes no tet uses");
    visit.field("dropped_shell", r.dropped_shell, "shell vertices no tet uses that are not locked");
    visit.field("bandwidth_before", r.bandwidth_before, "largest |i - j| of an edge in the mesh's node order");
    visit.field("max_inverse_error", r.max_inverse_error, "largest |inverse_rest Dm - I| / cond(Dm), Frobenius norms");
    visit.field("bundle", r.bundle, "what the bundle holds");
    visit.field("findings", r.findings, "what a person should know");
}

}
