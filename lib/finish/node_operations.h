// SPDX-License-Identifier: GPL-3.0-or-later
// What can be done with a single interior node to mend the tets at it: move it, merge it into a neighbour, or put a new
// one among bad tets.
#pragma once
#include <optional>

#include "finish/smoothing.h"
#include "finish/work_mesh.h"

namespace crumple::finish {

// Where to put a free node so that the worst tet of its star gets better than `floor`; its star's tets stay exactly
// positive.
[[nodiscard]] std::optional<BetterPlace> plan_move(const WorkMesh& mesh, Index node, std::span<const Index> star,
                                                   double floor);

// The faces opposite a node in the tets of its star.
[[nodiscard]] std::vector<OppositeFace> opposite_faces(const WorkMesh& mesh, Index node, std::span<const Index> star);

// Whether each of them makes a positive tet with a node at this place, exactly.
[[nodiscard]] bool is_positive_towards(Vec3 node, std::span<const OppositeFace> faces);

// The star of a free node without it: every face opposite it is joined to `target`, a node of the star. False unless
// every new tet is better than `floor` and exactly positive.
[[nodiscard]] bool plan_contraction(const WorkMesh& mesh, Index node, std::span<const Index> star, Index target,
                                    double floor, Exchange& exchange);

// A new node amid bad tets: the faces around a hole are joined to it and it is moved where that is best.
struct Insertion {
    Exchange exchange;  // the new node is written as `none`
    Vec3 place;
};

// At the middle of the edge (a, b), whose ring this is. False unless every new tet is better than `floor` and exactly
// positive.
[[nodiscard]] bool plan_insertion_on_edge(const WorkMesh& mesh, const TetRing& ring, Index a, Index b, double floor,
                                          Insertion& insertion);

// The best of the middles of the tet and of each of its edges. False likewise.
[[nodiscard]] bool plan_insertion(const WorkMesh& mesh, Index tet, double floor, Insertion& insertion);

}
