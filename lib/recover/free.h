// SPDX-License-Identifier: GPL-3.0-or-later
// Frees one segment or one facet by exchanging tets: every exchange leaves fewer obstacles than it found, or is undone.
// So it ends.
#pragma once
#include <cstdint>
#include <vector>

#include "core/index.h"
#include "mesh/tet_complex.h"
#include "recover/constraints.h"
#include "recover/crossings.h"
#include "recover/flips.h"

namespace crumple::recover {

enum class Outcome {
    there,    // an edge or face of the tets now
    stuck,    // no exchange helps
    blocked,  // by a part of the shell that is there already
    through,  // a node lies in it: Liberator::node()
};

// Whether a segment or facet of the shell that is there is among what is in the way.
[[nodiscard]] bool is_blocked(const Constraints& constraints, const std::vector<Crossing>& crossings);
[[nodiscard]] bool is_blocked(const Constraints& constraints, const FacetObstacles& obstacles);

class Liberator {
public:
    Liberator(TetComplex& complex, const Constraints& constraints)
        : complex_(complex), constraints_(constraints), flips_(complex, constraints) {}

    // depth: of edges that may be cleared to clear another one, 0 for none.
    Outcome free_segment(Index a, Index b, int depth);
    // REQUIRES: the three edges are there.
    Outcome free_facet(const Triangle& facet, int depth);

    // After `stuck` or `blocked`: what is left in the way.
    [[nodiscard]] const std::vector<Crossing>& crossings() const { return crossings_; }
    [[nodiscard]] const FacetObstacles& obstacles() const { return obstacles_; }
    [[nodiscard]] Index node() const { return node_; }
    [[nodiscard]] std::uint64_t exchanges() const { return flips_.count(); }
    // Looks at edges for all that is to become free. What needs none still comes free when there are none left.
    void set_budget(std::uint64_t looks) { budget_ = looks; }
    [[nodiscard]] std::uint64_t looks() const { return flips_.looks(); }
    [[nodiscard]] bool is_out_of_budget() const { return looks() >= budget_; }

private:
    bool exchange_for_segment(const Goal& goal);
    bool exchange_for_facet(const Goal& goal);
    bool clear_for_segment(const Goal& goal, int depth);
    bool clear_for_facet(const Goal& goal, int depth);

    TetComplex& complex_;
    const Constraints& constraints_;
    Flips flips_;
    std::vector<Crossing> crossings_;
    FacetObstacles obstacles_;
    Index node_ = none;
    std::uint64_t budget_ = 0;
};

}
