// SPDX-License-Identifier: GPL-3.0-or-later
// The time step that each node alone would allow an explicit simulation, but for a factor that is the same for all: the
// root of its mass over the stiffness of the tets at it, sum V / sum (A^2 / V), A the area of the face opposite the
// node. One flat tet at a node of little mass sets the step of the whole mesh, even where its angles are fair.
#pragma once
#include <vector>

#include "finish/work_mesh.h"

namespace crumple::finish {

// An exchange in which one node of the fresh tets may be elsewhere than the mesh says: a new one, written as `none`, or
// one that moves.
struct Change {
    Exchange exchange;
    bool is_placed = false;
    Index placed = none;
    Vec3 place;

    [[nodiscard]] Vec3 at(const WorkMesh& mesh, Index node) const {
        return is_placed && node == placed ? place : mesh.at(node);
    }
    [[nodiscard]] bool adds_node() const { return is_placed && placed == none; }
    [[nodiscard]] bool moves_node() const { return is_placed && placed != none; }
};

class NodeSteps {
public:
    explicit NodeSteps(const WorkMesh& mesh);

    // Metres; 0 for a node that no tet has.
    [[nodiscard]] double step(Index node) const { return step_of(loads_[node]); }
    [[nodiscard]] Index node_count() const { return static_cast<Index>(loads_.size()); }

    // The least among the nodes of a change, before and after it.
    struct Least {
        double before = 0;
        double after = 0;
    };
    [[nodiscard]] Least weigh(const WorkMesh& mesh, const Change& change);

    // The nodes of the change last weighed, ascending.
    [[nodiscard]] const std::vector<Index>& nodes() const { return nodes_; }

    // To be told before a change is carried out, and the number of the node it adds.
    void carry_out(const WorkMesh& mesh, const Change& change, Index added);

private:
    struct Load {
        double volume = 0;
        double stiffness = 0;
    };
    static double step_of(const Load& load);
    static void add(const Vec3 (&at)[4], int corner, double sign, Load& load);
    [[nodiscard]] Load& local_load(Index node);

    std::vector<Load> loads_;  // V

    // Working memory: of one change.
    std::vector<Index> nodes_;
    std::vector<Load> local_;  // of nodes_, then of an added one
};

}
