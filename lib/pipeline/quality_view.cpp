// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/quality_view.h"

#include <algorithm>
#include <limits>

#include "mesh/validate.h"
#include "quality/embedding.h"
#include "quality/shell_limits.h"
#include "quality/tet_fields.h"

namespace crumple::pipeline {

namespace {

// What the view shows, and how its nodes and those of the tet mesh are one another's.
struct Shown {
    std::vector<Vec3> positions;      // N
    std::vector<Tet> tets;            // T
    std::vector<Index> region;        // T or empty
    std::vector<Index> node_to_mesh;  // N
    std::vector<Index> mesh_to_node;
};

Shown shown_of(const Workspace& work) {
    Shown shown;
    if (work.bundle) {
        const Bundle& bundle = *work.bundle;
        for (const Vec3f p : bundle.rest_positions) shown.positions.push_back({p.x, p.y, p.z});
        shown.tets = bundle.tets;
        shown.region = bundle.region;
        shown.node_to_mesh = bundle.node_to_mesh;
        shown.mesh_to_node = bundle.mesh_to_node;
        return shown;
    }
    shown.positions = work.tets->positions;
    shown.tets = work.tets->tets;
    shown.region = work.tets->region;
    for (Index v = 0; v < shown.positions.size(); ++v) shown.node_to_mesh.push_back(v);
    shown.mesh_to_node = shown.node_to_mesh;
    return shown;
}

// The shell over the nodes that are shown. Empty when one of its vertices is not.
std::vector<Triangle> shown_triangles(const Shell& shell, const Shown& shown) {
    std::vector<Triangle> triangles;
    for (const Triangle& corners : shell.triangles) {
        Triangle nodes{none, none, none};
        for (int i = 0; i < 3; ++i) {
            if (corners[i] < shown.mesh_to_node.size()) nodes[i] = shown.mesh_to_node[corners[i]];
            if (nodes[i] == none) return {};
        }
        triangles.push_back(nodes);
    }
    return triangles;
}

void add_limits(const Shell& shell, const Shown& shown, store::ViewFields& fields) {
    const std::vector<Triangle> triangles = shown_triangles(shell, shown);
    if (triangles.empty()) return;
    const auto limits = quality::find_limits({shown.positions, triangles}, shown.positions, shown.tets);
    std::vector<std::uint8_t> values;
    for (const quality::ShellLimit limit : limits) values.push_back(static_cast<std::uint8_t>(limit));
    fields.cells.push_back({"shell_limit", std::move(values)});
}

// A shell vertex belongs to its component, an interior node to the region of its first tet.
std::vector<Index> components_of(const Shell& shell, const Shown& shown) {
    std::vector<Index> component(shown.positions.size(), none);
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        for (const Index v : shell.triangles[f]) {
            if (v < shown.mesh_to_node.size() && shown.mesh_to_node[v] != none)
                component[shown.mesh_to_node[v]] = shell.component[f];
        }
    }
    for (std::size_t t = 0; t < shown.region.size(); ++t) {
        for (const Index v : shown.tets[t]) {
            if (component[v] == none) component[v] = shown.region[t];
        }
    }
    return component;
}

// A node is as good as the worst tet at it; 0 where there is none.
std::vector<float> worst_at_nodes(const Shown& shown, const std::vector<float>& of_tets) {
    std::vector<float> worst(shown.positions.size(), std::numeric_limits<float>::infinity());
    for (std::size_t t = 0; t < shown.tets.size(); ++t) {
        for (const Index v : shown.tets[t]) worst[v] = std::min(worst[v], of_tets[t]);
    }
    std::replace(worst.begin(), worst.end(), std::numeric_limits<float>::infinity(), 0.0f);
    return worst;
}

// Largest distance and weight of the visual vertices hung on each tet that is shown, and their number.
class HungOn {
public:
    explicit HungOn(std::size_t tets) : count_(tets, 0), distance_(tets, 0), weight_(tets, 0) {}

    void add(Index tet, float distance, float weight) {
        ++count_[tet];
        distance_[tet] = std::max(distance_[tet], distance);
        weight_[tet] = std::max(weight_[tet], weight);
    }
    void move_to(std::vector<store::ViewField>& cells) {
        cells.push_back({"visual_vertices", std::move(count_)});
        cells.push_back({"visual_distance", std::move(distance_)});
        cells.push_back({"visual_weight", std::move(weight_)});
    }

private:
    std::vector<std::uint32_t> count_;
    std::vector<float> distance_;
    std::vector<float> weight_;
};

void add_visual(const VisualMesh& visual, quality::VertexEmbedding embedding, store::ViewFields& fields) {
    std::vector<Vec3f> positions;
    for (const Vec3 p : visual.positions) {
        positions.push_back(narrow(p));
    }
    fields.loose.push_back({visual.name + ".position", std::move(positions)});
    fields.loose.push_back({visual.name + ".distance", std::move(embedding.distance)});
    fields.loose.push_back({visual.name + ".weight", std::move(embedding.max_weight)});
    fields.loose.push_back({visual.name + ".bound_wrongly", std::move(embedding.bound_wrongly)});
}

// The bundle's tets have another order than those the bindings speak of; its own visuals say the same in it.
void add_embedding(const Workspace& work, const Shown& shown, store::ViewFields& fields) {
    auto measured = quality::measure_embedding(work.asset->shell, *work.tets, work.asset->visuals, *work.bindings);
    HungOn hung(shown.tets.size());
    for (std::size_t i = 0; i < measured.visuals.size(); ++i) {
        const std::vector<Index>& tet = work.bundle ? work.bundle->visuals[i].tet : (*work.bindings)[i].tet;
        const quality::VertexEmbedding& vertices = measured.visuals[i];
        for (std::size_t v = 0; v < tet.size(); ++v) hung.add(tet[v], vertices.distance[v], vertices.max_weight[v]);
        add_visual(work.asset->visuals[i], std::move(measured.visuals[i]), fields);
    }
    hung.move_to(fields.cells);
}

// Whatever a workspace holds, nothing out of range is read: a file with a flaw is still written, to be refused by its
// reader with the reason.
bool is_sound(const Shown& shown) {
    const auto is_node = [&](Index v) { return v < shown.positions.size(); };
    const bool has_places = std::all_of(shown.positions.begin(), shown.positions.end(), is_finite<double>);
    const bool has_nodes = std::all_of(shown.mesh_to_node.begin(), shown.mesh_to_node.end(),
                                       [&](Index v) { return v == none || is_node(v); });
    const bool has_regions = shown.region.empty() || shown.region.size() == shown.tets.size();
    return has_places && has_nodes && has_regions &&
           std::all_of(shown.tets.begin(), shown.tets.end(),
                       [&](const Tet& tet) { return std::all_of(tet.begin(), tet.end(), is_node); });
}

bool all_below(std::span<const Index> indices, std::size_t end) {
    return std::all_of(indices.begin(), indices.end(), [&](Index i) { return i < end; });
}

bool is_sound(const VisualBinding& binding, std::size_t vertices, std::size_t tets) {
    return binding.tet.size() == vertices && binding.barycentric.size() == vertices &&
           binding.inside.size() == vertices && binding.distance.size() == vertices && all_below(binding.tet, tets);
}

bool has_embedding(const Workspace& work) {
    if (!work.asset || !work.tets || !work.bindings || work.tets->region.empty()) return false;
    const std::vector<VisualMesh>& visuals = work.asset->visuals;
    const auto components = static_cast<Index>(work.asset->shell.components.size());
    if (!validate(*work.tets, components).empty() || work.bindings->size() != visuals.size()) return false;
    if (work.bundle && work.bundle->visuals.size() != visuals.size()) return false;
    for (std::size_t i = 0; i < visuals.size(); ++i) {
        const std::size_t vertices = visuals[i].positions.size();
        if (!is_sound((*work.bindings)[i], vertices, work.tets->tets.size())) return false;
        if (!work.bundle) continue;
        const std::vector<Index>& tet = work.bundle->visuals[i].tet;
        if (tet.size() != vertices || !all_below(tet, work.bundle->tets.size())) return false;
    }
    return true;
}

}

store::ViewFields quality_view(const Workspace& work) {
    store::ViewFields fields;
    if (!work.bundle && !work.tets) return fields;
    const Shown shown = shown_of(work);
    if (!is_sound(shown)) return fields;
    quality::TetFields shape = quality::measure_fields(shown.positions, shown.tets);
    fields.points.push_back({"min_dihedral_deg", worst_at_nodes(shown, shape.min_dihedral_deg)});
    fields.points.push_back({"element_step_ratio", worst_at_nodes(shown, shape.element_step_ratio)});
    fields.cells.push_back({"min_dihedral_deg", std::move(shape.min_dihedral_deg)});
    fields.cells.push_back({"volume_lrms3", std::move(shape.volume_lrms3)});
    fields.cells.push_back({"element_step_ratio", std::move(shape.element_step_ratio)});
    if (work.asset && validate(work.asset->shell).empty()) {
        if (!shown.region.empty()) add_limits(work.asset->shell, shown, fields);
        fields.points.push_back({"component", components_of(work.asset->shell, shown)});
        if (has_embedding(work)) add_embedding(work, shown, fields);
    }
    return fields;
}

}
