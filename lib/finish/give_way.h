// SPDX-License-Identifier: GPL-3.0-or-later
// Last resorts where the surface of the tets touches itself and no tet can go without costing the shell a vertex: new
// nodes let parts give way, a part of an edge's length, and every vertex keeps a tet. They cost tets.
#pragma once
#include "finish/tet_selection.h"

namespace crumple::finish {

// Where parts of tets meet only along the edge (node, end): all but the largest are bent off it, each by a node of its
// own in the middle. Empty when there is one part, or one that cannot be bent.
[[nodiscard]] SurfaceChange bend_off_edge(const TetSelection& tets, Index node, Index end);

// The tets at a node are cut through halfway and all tips but one go: the node stands free on it, and the surface that
// passed it in several sheets passes below in one. Empty when rounding would turn a tet inside out.
[[nodiscard]] SurfaceChange cut_tips(const TetSelection& tets, Index node);

}
