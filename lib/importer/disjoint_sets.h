// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of numbers that grow together.
#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

#include "core/index.h"

namespace crumple::importer {

class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

    Index find(Index i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    // The smaller root stays, so the result does not depend on the order.
    void unite(Index a, Index b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<Index> parent_;
};

}
