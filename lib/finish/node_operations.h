// SPDX-License-Identifier: GPL-3.0-or-later
// What can be done with a single interior node to mend the tets at it: move it or merge it into a neighbour.
#pragma once
#include <optional>

#include "finish/smoothing.h"
#include "finish/work_mesh.h"

namespace crumple::finish {

// Where to put a free node so that the worst tet of its star gets better than `floor`; its star's tets stay exactly
// positive.
[[nodiscard]] std::optional<BetterPlace> plan_move(const WorkMesh& mesh, Index node, std::span<const Index> star,
                                                   double floor);

// The face opposite a corner, so that (corner, face) is a positive tet.
[[nodiscard]] Triangle facing(const Tet& corners, int corner);

[[nodiscard]] OppositeFace places_of(const WorkMesh& mesh, const Triangle& face);

// The faces opposite a node in the tets of its star.
[[nodiscard]] std::vector<OppositeFace> opposite_faces(const WorkMesh& mesh, Index node, std::span<const Index> star);

// Whether each of them makes a positive tet with a node at this place, exactly.
[[nodiscard]] bool is_positive_towards(Vec3 node, std::span<const OppositeFace> faces);

// The star of a free node without it: every face opposite it is joined to `target`, a node of the star. False unless
// every new tet is better than `floor` and exactly positive.
[[nodiscard]] bool plan_contraction(const WorkMesh& mesh, Index node, std::span<const Index> star, Index target,
                                    double floor, Exchange& exchange);

}
