// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/insertion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

// The shape that any tet of these is to have.
constexpr double wanted = 0.4;

std::vector<Index> all_tets(const TetMesh& mesh) {
    std::vector<Index> tets(mesh.tets.size());
    std::iota(tets.begin(), tets.end(), Index{0});
    return tets;
}

TetMesh carried_out(const TetMesh& mesh, Insertion insertion) {
    WorkMesh work(mesh);
    const Index node = add_node(work, insertion.place);
    for (Tet& tet : insertion.exchange.fresh) {
        EXPECT_EQ(tet[0], none);
        tet[0] = node;
    }
    (void)apply(work, insertion.exchange);
    return take_mesh(work);
}

void expect_same_body(const TetMesh& result, const TetMesh& mesh) {
    EXPECT_TRUE(small::is_all_positive(result));
    EXPECT_NEAR(small::volume_of(result), small::volume_of(mesh), 1e-5);
    EXPECT_EQ(boundary_of(result).faces.size(), boundary_of(mesh).faces.size());
}

TEST(Insertion, AGoodTetGetsNoNode) {
    const TetMesh mesh = small::box_around({0.5, 0.5, 0.5});
    Insertion insertion;
    EXPECT_FALSE(plan_new_node(WorkMesh(mesh), 0, 0.5 * small::worst_of(mesh), 0, insertion));
}

TEST(Insertion, AFlatRingGetsANodeInItsMidst) {
    // Eight flat tets around a long edge: a node in the middle is much better than the edge.
    const TetMesh mesh = small::ring(8, 3);
    Insertion insertion;
    ASSERT_TRUE(plan_new_node(WorkMesh(mesh), 0, wanted, 0, insertion));
    EXPECT_GT(insertion.gain, 0);
    const TetMesh result = carried_out(mesh, insertion);
    expect_same_body(result, mesh);
    EXPECT_GE(small::worst_of(result), small::worst_of(mesh));
    EXPECT_EQ(result.positions.size(), mesh.positions.size() + 1);
}

TEST(Insertion, ANodeMustBeWorthItsPrice) {
    const TetMesh mesh = small::ring(8, 3);
    const WorkMesh work(mesh);
    Insertion insertion;
    ASSERT_TRUE(plan_new_node(work, 0, wanted, 0, insertion));
    const double gain = insertion.gain;
    EXPECT_FALSE(plan_new_node(work, 0, wanted, gain, insertion));
    EXPECT_TRUE(plan_new_node(work, 0, wanted, 0.99 * gain, insertion));
}

TEST(Insertion, KeepsToItsMaterial) {
    TetMesh mesh = small::ring(8, 3);
    for (Index t = 1; t < 8; t += 2) mesh.region[t] = 1;
    Insertion insertion;
    if (!plan_new_node(WorkMesh(mesh), 0, wanted, 0, insertion)) return;
    for (const Index t : insertion.exchange.old) EXPECT_EQ(mesh.region[t], mesh.region[0]);
}

TEST(Insertion, OnAnEdgeIsWithinItsRing) {
    const TetMesh mesh = small::ring(8, 3);
    const WorkMesh work(mesh);
    TetRing ring;
    work.complex.ring_of(0, 0, 1, ring);
    Insertion insertion;
    ASSERT_TRUE(plan_insertion_on_edge(work, ring, 0, 1, small::worst_of(mesh), insertion));
    expect_same_body(carried_out(mesh, insertion), mesh);
    EXPECT_FALSE(plan_insertion_on_edge(work, ring, 0, 1, 0.99, insertion));
}

TEST(Insertion, ANodeInACornerIsTakenOutAndPutInTheMiddle) {
    const TetMesh mesh = small::box_around({0.97, 0.96, 0.95});
    Insertion insertion;
    ASSERT_TRUE(plan_reseat(WorkMesh(mesh), 8, all_tets(mesh), wanted, 0, insertion));
    const TetMesh result = carried_out(mesh, insertion);
    expect_same_body(result, mesh);
    EXPECT_EQ(result.positions.size(), mesh.positions.size()) << "the old node is in no tet and goes";
    EXPECT_GT(small::worst_of(result), small::worst_of(mesh));
}

}
}
