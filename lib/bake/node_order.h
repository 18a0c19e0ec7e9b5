// SPDX-License-Identifier: GPL-3.0-or-later
// Renumbers nodes so that neighbours get near numbers. Decided by positions and topology, never by the old numbers.
#pragma once
#include <span>
#include <vector>

#include "bake/bake.h"

namespace crumple::bake {

// order[k] is the node that comes k-th. Nodes that no edge touches come last.
// positions: n; edges: pairs of nodes < n, each once in any order.
[[nodiscard]] std::vector<Index> order_nodes(std::span<const Vec3> positions, std::span<const Edge> edges,
                                             NodeOrder how);

}
