// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

#include "core/index.h"
#include "delaunay/sites.h"

namespace crumple::delaunay {

struct FirstSimplex {
    int dimension = -1;             // that the sites span: -1 no sites, 0 one, 1 a line, 2 a plane, 3 space
    std::array<Index, 4> vertex{};  // a positive tet when the dimension is 3
};

// Far-apart sites of full dimension, by exact decisions.
[[nodiscard]] FirstSimplex find_first_simplex(const Sites& sites);

}
