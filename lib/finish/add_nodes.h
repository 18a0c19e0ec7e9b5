// SPDX-License-Identifier: GPL-3.0-or-later
// Puts nodes amid the bad tets that nothing else mends, those first that mend most, and takes nodes out to put them in
// again where they mend more. A node costs a game about five tets, so it has a price in bad ones.
#pragma once
#include <cstdint>
#include <queue>
#include <vector>

#include "core/context.h"
#include "finish/insertion.h"
#include "finish/work_mesh.h"

namespace crumple::finish {

struct NodeLimits {
    double bad_deg = 10;  // tets whose shape is below that of this smallest angle are bad
    double price = 0.5;   // a new node must leave so many fewer bad tets (badness_of in hole.h)
};

struct NodeReport {
    std::uint64_t added = 0;
    std::uint64_t reseated = 0;
    std::uint64_t tried = 0;  // operations, whether they led to a change or not
    bool is_out_of_budget = false;
};

class NodeAdder {
public:
    // Keeps a reference to the mesh, which others may change between runs.
    NodeAdder(WorkMesh& mesh, const NodeLimits& limits);

    // Until no node would gain `level` bad tets more than its price. budget: operations tried at most.
    NodeReport run(double level, std::uint64_t budget, const Context& context);

private:
    struct Plan {
        Index tet = none;
        Index moved = none;  // the node that goes, none for a new one
        std::uint64_t made_at = 0;
        Insertion insertion;
    };
    struct Entry {
        double gain;
        Index plan;
        bool operator<(const Entry& other) const { return gain != other.gain ? gain < other.gain : plan > other.plan; }
    };

    void plan_all(const Context& context);
    void plan(Index tet);
    void plan_moves(Index tet, double& best, Plan& plan);
    [[nodiscard]] bool is_bad(Index tet) const;
    [[nodiscard]] bool has_changed_since(Index tet, std::uint64_t clock) const;
    [[nodiscard]] bool is_stale(const Plan& plan) const;
    void carry_out(Plan chosen);

    WorkMesh& mesh_;
    double bad_;
    NodeLimits limits_;
    NodeReport report_;  // of this run
    std::uint64_t budget_ = 0;
    std::vector<std::uint64_t> planned_at_;       // by slot: the clock then
    std::vector<std::uint64_t> node_planned_at_;  // V, for moves
    std::vector<Plan> plans_;
    std::priority_queue<Entry> waiting_;

    // Working memory.
    std::vector<Index> star_;
    Insertion trial_;
};

}
