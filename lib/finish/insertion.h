// SPDX-License-Identifier: GPL-3.0-or-later
// A node put amid bad tets: a hole is made around it, and the faces of the hole are joined to it [Klingner and Shewchuk
// 2007, "Aggressive tetrahedral mesh improvement"].
#pragma once
#include <span>

#include "finish/work_mesh.h"

namespace crumple::finish {

struct Insertion {
    Exchange exchange;  // the node is written as `none`
    Vec3 place;         // float-representable
    double gain = 0;    // badness (hole.h) before less badness after
};

// At the middle of the edge (a, b), whose ring this is. False unless every new tet is better than `floor` and exactly
// positive.
[[nodiscard]] bool plan_insertion_on_edge(const WorkMesh& mesh, const TetRing& ring, Index a, Index b, double floor,
                                          Insertion& insertion);

// A new node, at the best of several places in and around a tet. False unless it gains more than `price`, every new tet
// is as good as the worst that goes and exactly positive.
[[nodiscard]] bool plan_new_node(const WorkMesh& mesh, Index tet, double bad, double price, Insertion& insertion);

// A free node taken out with its star and put in again. False likewise.
[[nodiscard]] bool plan_reseat(const WorkMesh& mesh, Index node, std::span<const Index> star, double bad, double price,
                               Insertion& insertion);

}
