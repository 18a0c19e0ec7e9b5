// SPDX-License-Identifier: GPL-3.0-or-later
// What could be done about a node where the surface of the tets touches itself, with the nodes there are: parts at it
// taken away, given a node of their own, or joined.
#pragma once
#include <vector>

#include "finish/open_space.h"
#include "finish/tet_selection.h"

namespace crumple::finish {

// All that might help, in no order; whether one does is for the caller to try. may_split: the node may get copies.
[[nodiscard]] std::vector<SurfaceChange> surface_changes_at(const TetSelection& tets, const OpenSpace& space,
                                                            Index node, bool may_split);

}
