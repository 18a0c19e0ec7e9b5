// SPDX-License-Identifier: GPL-3.0-or-later
// The mesh under repair with what every operation asks about it: the shape of each tet, which nodes may move, which
// nodes lie on the surface. Operations plan an Exchange without touching anything; `apply` carries it out.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "finish/shape.h"
#include "mesh/tet_complex.h"
#include "mesh/tet_mesh.h"

namespace crumple::finish {

// Tets that go, tets that come in their place, all of one region.
struct Exchange {
    std::vector<Index> old;
    std::vector<Tet> fresh;
    double least = 0;  // shape of the worst fresh tet

    void clear() {
        old.clear();
        fresh.clear();
        least = 0;
    }
};

struct WorkMesh {
    explicit WorkMesh(const TetMesh& mesh);

    [[nodiscard]] double shape(Index tet) const { return shapes[tet]; }
    [[nodiscard]] Vec3 at(Index node) const { return complex.position(node); }
    [[nodiscard]] bool is_exposed(Index tet, int corner) const { return complex.neighbour(tet, corner) == none; }

    TetComplex complex;
    std::vector<double> shapes;               // by slot
    std::vector<std::uint8_t> is_on_surface;  // V: some face at it is exposed
    std::vector<std::uint8_t> is_free;        // V: interior node, not on the surface, all its tets of one region
    std::vector<std::uint8_t> is_surplus;     // V: none of the shell's, on the surface, all its tets of one region
    std::vector<std::uint8_t> is_pinched;     // V: the surface touches itself there; left alone

    // When a tet at a node last changed and when a tet was last tried in vain, counted in changes.
    std::uint64_t clock = 1;
    std::vector<std::uint64_t> changed_at;  // V
    std::vector<std::uint64_t> tried_at;    // by slot
};

// Whether orient3d says so, exactly, for every one.
[[nodiscard]] bool are_positive(const WorkMesh& mesh, std::span<const Tet> tets);

// The worst of them; 1 for none.
[[nodiscard]] double least_shape(const WorkMesh& mesh, std::span<const Index> tets);

[[nodiscard]] double shape_of(const WorkMesh& mesh, const Tet& tet);

[[nodiscard]] bool is_of_one_region(const WorkMesh& mesh, std::span<const Index> tets);

// REQUIRES: exchange.old not empty, of one region. The slots of the fresh tets, good until the next change.
std::span<const Index> apply(WorkMesh& mesh, const Exchange& exchange);

// A free node, in no tet yet.
Index add_node(WorkMesh& mesh, Vec3 place);

// Moves a node and weighs the tets at it again.
void move_node(WorkMesh& mesh, Index node, Vec3 place, std::span<const Index> star);

// Marks the nodes again: after tets were thrown away.
void find_surface(WorkMesh& mesh);

// Without the interior nodes that no tet uses any more; tets by slot, the others in their order.
[[nodiscard]] TetMesh take_mesh(const WorkMesh& mesh);

}
