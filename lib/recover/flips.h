// SPDX-License-Identifier: GPL-3.0-or-later
// Exchanges of a few tets for others in the same place that keep every tet positive: an edge goes and the ring around
// it is triangulated anew [Freitag and Ollivier-Gooch 1997; Shewchuk 2002, "Two discrete optimization algorithms"], or
// a face goes and an edge takes its place. What is a segment or a facet already is never taken away. Everything can be
// undone.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/index.h"
#include "mesh/tet_complex.h"
#include "recover/constraints.h"
#include "recover/crossings.h"

namespace crumple::recover {

// What is to become free: a segment (c = none) or a facet. Obstacles are faces and edges that meet its inside.
struct Goal {
    Index a = none;
    Index b = none;
    Index c = none;

    [[nodiscard]] bool is_facet() const { return c != none; }
};

// How many obstacles a face (p, q, r) is in itself, its edges not counted: 0 or 1.
[[nodiscard]] int face_in_way(const TetComplex& complex, const Goal& goal, Index p, Index q, Index r);
[[nodiscard]] int edge_in_way(const TetComplex& complex, const Goal& goal, Index p, Index q);

struct Exchange {
    std::vector<Index> old;
    std::vector<Tet> fresh;
    int gain = 0;        // obstacles fewer
    double quality = 0;  // of the worst fresh tet, by quality_of
};

class Flips {
public:
    Flips(TetComplex& complex, const Constraints& constraints) : complex_(complex), constraints_(constraints) {}

    // The way to take an edge out that leaves fewest obstacles, then the best worst tet; false when there is none.
    bool plan_edge_removal(const Goal& goal, Index tet, Index u, Index v, Exchange& exchange);

    // Takes the face opposite `corner` of a tet out; an edge between the apexes on both sides comes in.
    bool plan_face_removal(const Goal& goal, Index tet, int corner, Exchange& exchange);

    void apply(const Exchange& exchange);

    // Takes the edge (u, v) out whatever it costs, first others that keep it from going, down to `depth` of them deep.
    // REQUIRES: (u, v) is an edge. On false nothing has changed.
    bool clear_edge(Index u, Index v, int depth);

    // How often clear_edge may look at an edge from now on; large rings count more.
    void set_budget(int looks) { looks_left_ = looks; }
    [[nodiscard]] std::uint64_t looks() const { return looks_; }  // in all

    [[nodiscard]] std::size_t mark() const { return journal_.size(); }
    void roll_back(std::size_t mark);
    void forget() { journal_.clear(); }
    [[nodiscard]] std::uint64_t count() const { return count_; }  // of exchanges that were not undone

private:
    struct Entry {
        std::vector<Tet> old;
        std::vector<Tet> fresh;
    };
    struct Cell {
        int cost = 0;
        double quality = 0;
        int middle = -1;
        bool is_possible = false;
    };

    void fill_table(const Goal& goal, Index u, Index v);
    void fill_cell(const Goal& goal, Index u, Index v, int first, int last);
    void read_table(Index u, Index v, int first, int last, std::vector<Tet>& fresh) const;
    [[nodiscard]] int obstacles_at_edge(const Goal& goal, Index u, Index v) const;
    [[nodiscard]] Index slot_of(const Tet& tet) const;
    Cell& cell(int first, int last) { return table_[static_cast<std::size_t>(first) * ring_.link.size() + last]; }
    [[nodiscard]] const Cell& cell(int first, int last) const {
        return table_[static_cast<std::size_t>(first) * ring_.link.size() + last];
    }

    TetComplex& complex_;
    const Constraints& constraints_;
    std::vector<Entry> journal_;
    std::uint64_t count_ = 0;
    int looks_left_ = 0;
    std::uint64_t looks_ = 0;
    TetRing ring_;
    std::vector<Cell> table_;
};

// 6 sqrt(2) V / lrms^3, lrms the root mean square edge: 1 for a regular tet, positive for a positive one.
[[nodiscard]] double quality_of(const TetComplex& complex, const Tet& tet);

}
