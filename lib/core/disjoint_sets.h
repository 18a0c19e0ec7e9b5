// SPDX-License-Identifier: MIT
// Sets of numbers that grow together; each is named by its least member.
#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

#include "core/index.h"

namespace crumple {

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
