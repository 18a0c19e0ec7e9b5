// SPDX-License-Identifier: GPL-3.0-or-later
// Throws away tetrahedra outside the shell and the interior nodes nobody uses any more.
// Shell vertices keep their indices, so anything baked against the shell stays valid.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"

namespace crumple::cull {

inline constexpr int version = 1;

struct Params {
    double min_inside = 0.5;
    std::uint32_t samples = 20;
    std::uint32_t hausdorff_samples = 4000;
};

template <class Visitor, FieldsOf<Params> P>
void describe(Visitor& visit, P& p) {
    visit.field("min_inside", p.min_inside, Range{0, 1},
                "keep a tet when more than this share of its samples lies in material");
    visit.field(
        "samples", p.samples, Range{8, 1000},
        "sample points of a tet that the surface passes through, at least; rounded up to 10, 20, 35, 56, 84, ...");
    visit.field("hausdorff_samples", p.hausdorff_samples, Range{0, 10000000},
                "points spread over a surface to measure its distance from the other one, besides its vertices");
}

// What became of one shell component.
struct Region {
    std::string name;
    Role role = Role::solid;
    std::uint64_t tets = 0;
    double volume = 0;  // cubic metres of those tets
    std::uint64_t unused_vertices = 0;
};

template <class Visitor, FieldsOf<Region> P>
void describe(Visitor& visit, P& p) {
    visit.field("name", p.name, "shell component");
    visit.field("role", p.role, "what the space inside it is");
    visit.field("tets", p.tets, "tets whose material it is");
    visit.field("volume", p.volume, "of those tets, cubic metres");
    visit.field("unused_vertices", p.unused_vertices, "of its vertices, those no tet uses");
}

// "The solid" is the union of the shell's solid and rigid components without its cavities, the innermost deciding.
struct Report {
    std::uint64_t tets = 0;
    std::uint64_t kept = 0;
    std::uint64_t straddling = 0;
    std::uint64_t nodes = 0;
    std::uint64_t dropped_nodes = 0;
    double volume = 0;
    double shell_volume = 0;
    bool shell_volume_is_exact = true;
    double volume_error = 0;
    double hausdorff_out = 0;
    double hausdorff_in = 0;
    std::uint64_t pieces = 0;
    std::uint64_t shell_pieces = 0;
    std::uint64_t non_manifold_edges = 0;
    std::uint64_t non_manifold_vertices = 0;
    std::uint64_t unused_shell_vertices = 0;
    double leak_share = 0;
    std::vector<Region> regions;
    std::vector<Finding> findings;  // CULL_*
};

template <class Visitor, FieldsOf<Report> P>
void describe(Visitor& visit, P& p) {
    visit.field("tets", p.tets, "tets that came in");
    visit.field("kept", p.kept, "tets inside the solid");
    visit.field("straddling", p.straddling, "tets that a shell triangle passes through, or may: decided by samples");
    visit.field("nodes", p.nodes, "nodes left, shell vertices and interior");
    visit.field("dropped_nodes", p.dropped_nodes, "interior nodes that no tet uses any more");
    visit.field("volume", p.volume, "of the tets kept, cubic metres");
    visit.field("shell_volume", p.shell_volume, "of the solid, cubic metres");
    visit.field("shell_volume_is_exact", p.shell_volume_is_exact,
                "false: shells are open, cross or touch, so the solid was estimated from samples, stratified by tets");
    visit.field("volume_error", p.volume_error, "|volume - shell_volume| / shell_volume");
    visit.field("hausdorff_out", p.hausdorff_out,
                "farthest the tets' surface strays from the shell, share of the shell's diagonal");
    visit.field("hausdorff_in", p.hausdorff_in,
                "farthest the solid's surface strays from the tets', share of the shell's diagonal");
    visit.field("pieces", p.pieces, "pieces of tets connected by faces");
    visit.field("shell_pieces", p.shell_pieces, "pieces the solid has");
    visit.field("non_manifold_edges", p.non_manifold_edges, "edges of the tets' surface with more than two faces");
    visit.field("non_manifold_vertices", p.non_manifold_vertices, "nodes where the tets' surface is no single fan");
    visit.field("unused_shell_vertices", p.unused_shell_vertices, "shell vertices that no tet uses");
    visit.field(
        "leak_share", p.leak_share,
        "volume share of tets whose winding number lies between 0.3 and 0.7 among those above 0.3: how undecided "
        "inside and outside are where the shell is open");
    visit.field("regions", p.regions, "by shell component");
    visit.field("findings", p.findings, "what a person should know");
}

struct Result {
    TetMesh
        mesh;  // tets in the order they came, region and neighbours filled; interior nodes close ranks in their order
    Report report;
};

// REQUIRES: mesh fills the shell's convex hull, every tet positive, and holds every shell vertex at its shell index.
// Throws Error(bad_input) when no tet is left.
[[nodiscard]] Result cull_outside(const Shell& shell, TetMesh mesh, const Params& params = {},
                                  const Context& context = {});

}
