// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <numeric>
#include <vector>

#include "recover/insert_node.h"

namespace crumple::recover {

// Of all tets those that hold the place.
inline std::vector<Index> all_holders(const TetComplex& complex, Vec3 place) {
    std::vector<Index> all;
    for (Index t = 0; t < complex.slot_count(); ++t) {
        if (complex.is_tet(t)) all.push_back(t);
    }
    return holders_of(complex, all, place);
}

}
