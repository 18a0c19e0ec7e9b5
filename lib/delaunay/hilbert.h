// SPDX-License-Identifier: GPL-3.0-or-later
// Points along a Hilbert curve: neighbours in the order are neighbours in space, for the cache and for short walks.
#pragma once
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"

namespace crumple::delaunay {

// Indices of the points in curve order over their bounding cube, ties by coordinates: equal points end up side by side,
// in the order of their indices.
[[nodiscard]] std::vector<Index> hilbert_order(std::span<const Vec3> positions);

}
