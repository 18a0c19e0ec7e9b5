// SPDX-License-Identifier: GPL-3.0-or-later
// The whole task: every segment and facet in turn, splits where they are stuck, splits taken back at the end.
#pragma once
#include <cstdint>
#include <deque>
#include <vector>

#include "core/context.h"
#include "mesh/tet_complex.h"
#include "recover/constraints.h"
#include "recover/free.h"
#include "recover/recover.h"
#include "recover/splits.h"

namespace crumple::recover {

class Recovery {
public:
    Recovery(TetComplex& complex, Constraints& constraints, const Params& params, std::size_t max_splits,
             const Context& context);

    void run();

    // What is not there, ascending.
    [[nodiscard]] std::vector<Edge> missing_segments() const;
    [[nodiscard]] std::vector<Triangle> missing_facets() const;

    [[nodiscard]] const std::vector<Split>& splits() const { return splits_; }  // that stay
    [[nodiscard]] std::uint64_t splits_tried() const { return splits_tried_; }
    [[nodiscard]] std::uint64_t exchanges() const { return liberator_.exchanges(); }

private:
    void free_segments(int depth);
    void free_facets(int depth);
    bool split_stuck_segments();
    bool split_stuck_facets();
    bool split_at_crossing(const Edge& segment);
    bool split_at_obstacle(const Triangle& facet);
    void undo_splits();
    [[nodiscard]] bool has_edge(Index a, Index b) const { return complex_.find_edge(a, b) != none; }
    [[nodiscard]] bool has_face(const Triangle& t) const { return complex_.find_face(t[0], t[1], t[2]) != none; }
    [[nodiscard]] bool matters(const Edge& segment) const;
    [[nodiscard]] bool matters(const Triangle& facet) const;

    TetComplex& complex_;
    Constraints& constraints_;
    const Params& params_;
    const Context& context_;
    Liberator liberator_;
    std::size_t splits_left_;
    std::uint64_t splits_tried_ = 0;
    std::vector<Split> splits_;
};

}
