// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs every vertex of the visual meshes on the tet that contains it, else on the nearest.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/bindings.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"
#include "mesh/visual_mesh.h"

namespace crumple::bind {

inline constexpr int version = 1;

struct Params {
    double max_weight = 1.5;
    double nearest_slack = 1e-6;
};

template <class Visitor, FieldsOf<Params> P>
void describe(Visitor& visit, P& p) {
    visit.field("max_weight", p.max_weight, Range{1, 1e6},
                "largest |weight| of a vertex outside the tets that passes without a finding");
    visit.field(
        "nearest_slack", p.nearest_slack, Range{0, 1},
        "where the nearest tet would exceed max_weight, tets farther by no more than this share of the tets' diagonal "
        "count as nearest too, and the least extrapolating one wins: slivers on the surface lose to what lies behind");
}

struct VisualReport {
    std::string name;
    std::string owner;
    std::uint64_t vertices = 0;
    std::uint64_t outside = 0;
    double max_distance = 0;
    double mean_distance = 0;
    double max_weight = 0;
    std::uint64_t extrapolated = 0;
};

template <class Visitor, FieldsOf<VisualReport> P>
void describe(Visitor& visit, P& p) {
    visit.field("name", p.name, "visual mesh");
    visit.field("owner", p.owner, "shell component it hangs on alone; empty: whichever contains a vertex");
    visit.field("vertices", p.vertices, "vertices of the visual mesh");
    visit.field("outside", p.outside, "vertices that no tet of the owner contains");
    visit.field("max_distance", p.max_distance, "of an outside vertex from its tet, metres");
    visit.field("mean_distance", p.mean_distance, "of the outside vertices from their tets, metres");
    visit.field("max_weight", p.max_weight, "largest |weight|; 1 or less inside");
    visit.field("extrapolated", p.extrapolated, "vertices with a |weight| beyond max_weight");
}

struct Report {
    std::uint64_t vertices = 0;
    std::uint64_t outside = 0;
    double max_distance = 0;
    double max_weight = 0;
    std::uint64_t extrapolated = 0;
    std::vector<VisualReport> visuals;
    std::vector<Finding> findings;  // BIND_*
};

template <class Visitor, FieldsOf<Report> P>
void describe(Visitor& visit, P& p) {
    visit.field("vertices", p.vertices, "vertices of all visual meshes");
    visit.field("outside", p.outside, "vertices that no tet of their owner contains");
    visit.field("max_distance", p.max_distance, "of an outside vertex from its tet, metres");
    visit.field("max_weight", p.max_weight, "largest |weight|; 1 or less inside");
    visit.field("extrapolated", p.extrapolated, "vertices with a |weight| beyond max_weight");
    visit.field("visuals", p.visuals, "by visual mesh");
    visit.field("findings", p.findings, "what a person should know");
}

struct Result {
    Bindings bindings;  // one per visual mesh, in their order
    Report report;
};

// The tet of a vertex depends on places alone, not on the order of tets, vertices or threads. A vertex on the border of
// two regions hangs on the innermost one. REQUIRES: mesh positive, with neighbours and a region for every tet. Throws
// Error(bad_input) when there is no tet, or a visual vertex is not finite.
[[nodiscard]] Result bind_visuals(const Shell& shell, const TetMesh& mesh, std::span<const VisualMesh> visuals,
                                  const Params& params = {}, const Context& context = {});

}
