// SPDX-License-Identifier: GPL-3.0-or-later
// The whole task: every segment and facet in turn, splits where they are stuck, splits taken back at the end.
#pragma once
#include <algorithm>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "core/context.h"
#include "mesh/tet_complex.h"
#include "recover/constraints.h"
#include "recover/free.h"
#include "recover/recover.h"
#include "recover/splits.h"

namespace crumple::recover {

// What is not there, by the reason.
template <class Nodes>
struct Missing {
    std::vector<Nodes> negligible;  // the tets' own faces run next to it
    std::vector<Nodes> blocked;     // another part of the shell runs through it
    std::vector<Nodes> stuck;       // out of means

    [[nodiscard]] std::size_t count() const { return negligible.size() + blocked.size() + stuck.size(); }
};

class Recovery {
public:
    Recovery(TetComplex& complex, Constraints& constraints, const Params& params, const Context& context);

    void run();

    // Ascending.
    [[nodiscard]] std::vector<Edge> missing_segments() const;
    [[nodiscard]] std::vector<Triangle> missing_facets() const;
    [[nodiscard]] Missing<Edge> judge_segments() const;
    [[nodiscard]] Missing<Triangle> judge_facets(const Missing<Edge>& segments) const;

    [[nodiscard]] const std::vector<Split>& splits() const { return splits_; }  // that stay
    [[nodiscard]] std::uint64_t splits_tried() const { return splits_tried_; }
    [[nodiscard]] std::uint64_t exchanges() const { return liberator_.exchanges(); }
    [[nodiscard]] std::uint64_t looks() const { return liberator_.looks(); }
    [[nodiscard]] bool is_out_of_budget() const { return liberator_.is_out_of_budget(); }

private:
    // Each tells whether some that matter are stuck.
    bool free_segments(std::uint32_t depth);
    bool free_facets(std::uint32_t depth);
    bool free_all();
    void start_pass();
    // Each tells whether it put nodes anywhere.
    bool split_stuck_segments();
    bool split_stuck_facets();
    bool split_at_crossing(const Edge& segment);
    bool split_at_obstacle(const Triangle& facet);
    // Whether some left.
    bool undo_splits();
    void drop_splits();
    void add_parts(const Split& split);

    [[nodiscard]] bool may_split() const;
    [[nodiscard]] bool has_edge(Index a, Index b) const { return complex_.find_edge(a, b) != none; }
    [[nodiscard]] bool has_edges(const Triangle& t) const {
        return has_edge(t[0], t[1]) && has_edge(t[1], t[2]) && has_edge(t[2], t[0]);
    }
    [[nodiscard]] bool has_face(const Triangle& t) const { return complex_.find_face(t[0], t[1], t[2]) != none; }

    // Parts of a split matter always, with their edges: only when all are there can it be taken back.
    template <class Nodes>
    [[nodiscard]] bool is_part(const Nodes& nodes) const {
        return std::any_of(nodes.begin(), nodes.end(), [&](Index v) { return v >= node_count_; });
    }
    [[nodiscard]] bool matters(const Edge& segment) const;
    [[nodiscard]] bool matters(const Triangle& facet) const;
    [[nodiscard]] double length_of(Index a, Index b) const {
        return length(complex_.position(b) - complex_.position(a));
    }
    [[nodiscard]] double size_of(const Triangle& t) const {
        return std::max({length_of(t[0], t[1]), length_of(t[1], t[2]), length_of(t[2], t[0])});
    }

    TetComplex& complex_;
    Constraints& constraints_;
    const Params& params_;
    const Context& context_;
    Liberator liberator_;
    Index node_count_;        // before any split
    double largest_loss_;     // metres that may be neglected
    std::size_t max_splits_;  // at one time
    std::uint64_t splits_tried_ = 0;
    std::vector<Split> splits_;

    // Of this pass: what may be missing, and what was tried at full depth in vain.
    std::vector<Edge> todo_segments_;
    std::vector<Triangle> todo_facets_;
    std::unordered_set<Edge, EdgeHash> tired_segments_;
    std::unordered_set<Triangle, TriangleHash> tired_facets_;
    // Freed as far as they can be: trying again would only disturb the others.
    std::unordered_set<Edge, EdgeHash> blocked_segments_;
    std::unordered_set<Triangle, TriangleHash> blocked_facets_;
};

}
