// SPDX-License-Identifier: GPL-3.0-or-later
// How well visual meshes sit in the tets they hang on.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/bindings.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"
#include "mesh/visual_mesh.h"

namespace crumple::quality {

struct Embedding {
    std::uint64_t vertices = 0;
    std::uint64_t outside = 0;
    double max_weight = 0;
    std::uint64_t bound_wrongly = 0;
};

template <class Visitor, FieldsOf<Embedding> E>
void describe(Visitor& visit, E& e) {
    visit.field("vertices", e.vertices, "vertices of all visual meshes");
    visit.field("outside", e.outside, "vertices that their tet does not contain");
    visit.field("max_weight", e.max_weight, "largest |weight|; 1 or less inside");
    visit.field("bound_wrongly", e.bound_wrongly,
                "vertices whose tet belongs to another shell although a tet of the owning shell contains them or is no "
                "farther away");
}

// The same for one visual mesh, vertex by vertex. V vertices.
struct VertexEmbedding {
    std::vector<float> distance;              // V: metres outside its tet, 0 inside
    std::vector<float> max_weight;            // V: largest |weight|
    std::vector<std::uint8_t> bound_wrongly;  // V
};

// A vertex worth telling of: its visual mesh is in the name, with the weight where that is why.
struct HungVertex {
    Place place;
    Index tet = none;  // it hangs on
};

// At most max_places of each kind.
struct EmbeddingResult {
    Embedding total;
    std::vector<VertexEmbedding> visuals;
    std::vector<HungVertex> wrong;     // bound wrongly, the first ones
    std::vector<HungVertex> heaviest;  // of the largest weights above 1, largest first
};

// A visual mesh that names a shell component belongs to it; of one that does not, a vertex belongs to the component
// whose material fills its place, if there is one. Components without tets own nothing. REQUIRES: a region for every
// tet; bindings of these visuals to these tets.
[[nodiscard]] EmbeddingResult measure_embedding(const Shell& shell, const TetMesh& mesh,
                                                std::span<const VisualMesh> visuals, const Bindings& bindings,
                                                const Context& context = {});

}
