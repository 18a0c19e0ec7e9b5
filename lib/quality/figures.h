// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that is measured of a mesh before it is trusted.
#pragma once
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"
#include "quality/cost.h"
#include "quality/embedding.h"
#include "quality/quality.h"
#include "quality/shell_limits.h"

namespace crumple::quality {

// The surface of the tets, and of what it should be.
struct Topology {
    std::uint64_t non_manifold_edges = 0;
    std::uint64_t non_manifold_vertices = 0;
    std::uint64_t pieces = 0;
    std::uint64_t shell_pieces = 0;
};

template <class Visitor, FieldsOf<Topology> T>
void describe(Visitor& visit, T& t) {
    visit.field("non_manifold_edges", t.non_manifold_edges, "edges of the tets' surface with other than two faces");
    visit.field("non_manifold_vertices", t.non_manifold_vertices, "nodes where that surface is no single fan");
    visit.field("pieces", t.pieces, "pieces of tets connected by faces");
    visit.field("shell_pieces", t.shell_pieces, "pieces the shell's solid has, 0: not known");
}

// How well the tets keep to the shell. Measured by whoever has the shell (cull/fidelity.h): only carried here.
struct Fidelity {
    bool is_known = false;
    bool is_closed = false;
    double volume_error = 0;
    double hausdorff_out = 0;
    double hausdorff_in = 0;
    double leak_share = 0;
    Vec3 farthest_out;  // where the tets' surface strays most from the shell, metres
    Vec3 farthest_in;   // where the solid's surface strays most from the tets'
};

template <class Visitor, FieldsOf<Fidelity> F>
void describe(Visitor& visit, F& f) {
    visit.field("is_known", f.is_known, "false: there was no shell to compare with, the rest is 0");
    visit.field("is_closed", f.is_closed,
                "the shell's components are closed, so that distances both ways mean something");
    visit.field("volume_error", f.volume_error, "(volume - volume of the shell's solid) / that");
    visit.field("hausdorff_out", f.hausdorff_out, "farthest the tets' surface strays, share of the shell's diagonal");
    visit.field("hausdorff_in", f.hausdorff_in, "farthest the solid's surface strays from the tets', the same");
    visit.field("leak_share", f.leak_share, "volume share of tets whose winding number lies between 0.3 and 0.7");
}

struct Figures {
    Summary shape;
    Cost cost;
    std::uint64_t below_10_thin = 0;
    std::uint64_t below_10_needle = 0;
    Topology topology;
    Fidelity fidelity;
    Embedding embedding;
};

template <class Visitor, FieldsOf<Figures> F>
void describe(Visitor& visit, F& f) {
    visit.field("shape", f.shape, "of the tets");
    visit.field("cost", f.cost, "to simulate them");
    visit.field("below_10_thin", f.below_10_thin,
                "tets below 10 degrees where the shell is so thin for its edges that none could be better");
    visit.field("below_10_needle", f.below_10_needle,
                "tets below 10 degrees on a triangle of the shell that has such a corner itself");
    visit.field("topology", f.topology, "of their surface");
    visit.field("fidelity", f.fidelity, "to the shell");
    visit.field("embedding", f.embedding, "of the visual meshes");
}

// Shape, cost, limits and the tets' side of the topology; fidelity, shell_pieces and embedding are left to the caller.
// `shell` tells what it forces; null: the surface of the tets stands for it.
// REQUIRES: indices in range; mesh.neighbours is filled.
[[nodiscard]] Figures measure(const TetMesh& mesh, const Shell* shell, const Context& context = {});

}
