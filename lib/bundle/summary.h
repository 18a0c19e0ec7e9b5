// SPDX-License-Identifier: MIT
// What a bundle holds, in a few numbers, for people and for `inspect`.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "bundle/bundle.h"
#include "core/fields.h"

namespace crumple {

struct VisualSummary {
    std::string name;
    std::uint64_t vertices = 0;
    std::uint64_t outside = 0;  // vertices bound to a tet that does not contain them
    double max_distance = 0;    // metres, of those outside
    double max_abs_weight = 0;  // 1 where all are inside
};

struct SensorSummary {
    std::string name;
    std::uint64_t nodes = 0;
    Vec3 origin;
};

struct MaterialSummary {
    std::string name;
    std::uint64_t tets = 0;
    double mass_kg = 0;
};

struct RegionSummary {
    std::string name;
    std::uint64_t tets = 0;
    double volume_m3 = 0;
};

struct BundleSummary {
    std::uint64_t nodes = 0;
    std::uint64_t locked_nodes = 0;
    std::uint64_t unused_locked_nodes = 0;  // painted, but no tet uses them
    std::uint64_t tets = 0;
    std::uint64_t solver_tets = 0;
    std::uint64_t blocks = 0;
    std::uint64_t edges = 0;
    std::uint64_t bandwidth = 0;  // largest |i - j| of an edge
    Vec3 box_low;
    Vec3 box_high;
    double volume_m3 = 0;
    double mass_kg = 0;
    std::vector<MaterialSummary> materials;
    std::vector<RegionSummary> regions;
    std::vector<VisualSummary> visuals;
    std::vector<SensorSummary> sensors;
};

// REQUIRES: validate(bundle) is empty.
[[nodiscard]] BundleSummary summarize(const Bundle& bundle);

template <class Visitor, FieldsOf<VisualSummary> S>
void describe(Visitor& visit, S& s) {
    visit.field("name", s.name, "visual mesh");
    visit.field("vertices", s.vertices, "vertices of the visual mesh");
    visit.field("outside", s.outside, "vertices bound to a tet that does not contain them");
    visit.field("max_distance", s.max_distance, "largest distance of those to their tet, metres");
    visit.field("max_abs_weight", s.max_abs_weight, "largest size of a barycentric weight");
}

template <class Visitor, FieldsOf<SensorSummary> S>
void describe(Visitor& visit, S& s) {
    visit.field("name", s.name, "sensor");
    visit.field("nodes", s.nodes, "control nodes that carry it");
    visit.field("origin", s.origin, "rest position, metres");
}

template <class Visitor, FieldsOf<MaterialSummary> S>
void describe(Visitor& visit, S& s) {
    visit.field("name", s.name, "material");
    visit.field("tets", s.tets, "tets made of it");
    visit.field("mass_kg", s.mass_kg, "mass of those");
}

template <class Visitor, FieldsOf<RegionSummary> S>
void describe(Visitor& visit, S& s) {
    visit.field("name", s.name, "shell component");
    visit.field("tets", s.tets, "tets inside it");
    visit.field("volume_m3", s.volume_m3, "volume of those");
}

template <class Visitor, FieldsOf<BundleSummary> S>
void describe(Visitor& visit, S& s) {
    visit.field("nodes", s.nodes, "control nodes");
    visit.field("locked_nodes", s.locked_nodes, "nodes that never move by themselves");
    visit.field("unused_locked_nodes", s.unused_locked_nodes, "locked nodes no tet uses");
    visit.field("tets", s.tets, "tetrahedra");
    visit.field("solver_tets", s.solver_tets, "tets that enter the matrix");
    visit.field("blocks", s.blocks, "3 x 3 blocks of the matrix");
    visit.field("edges", s.edges, "edges of the solver tets");
    visit.field("bandwidth", s.bandwidth, "largest distance of a block from the diagonal");
    visit.field("box_low", s.box_low, "lowest corner of the rest positions, metres");
    visit.field("box_high", s.box_high, "highest corner of the rest positions, metres");
    visit.field("volume_m3", s.volume_m3, "volume of all tets");
    visit.field("mass_kg", s.mass_kg, "mass of all nodes");
    visit.field("materials", s.materials, "the material table");
    visit.field("regions", s.regions, "the shell's components");
    visit.field("visuals", s.visuals, "visual meshes bound to the tets");
    visit.field("sensors", s.sensors, "named frames");
}

}
