// SPDX-License-Identifier: GPL-3.0-or-later
// Which tets meet across each face, from the corners alone.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "core/index.h"

namespace crumple {

// T x 4: the tet across the face opposite corner i, none at the boundary. Throws Error(internal) when three tets share
// a face.
[[nodiscard]] std::vector<std::array<Index, 4>> neighbours_of(std::span<const Tet> tets);

}
