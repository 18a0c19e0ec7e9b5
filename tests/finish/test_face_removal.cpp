// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/face_removal.h"

#include <gtest/gtest.h>

#include "small_meshes.h"

namespace crumple::finish {
namespace {

// The best removal that starts at some face of some tet.
TetMesh remove_best(const TetMesh& mesh, double floor, bool& is_found) {
    WorkMesh work(mesh);
    Exchange best;
    best.least = floor;
    is_found = false;
    for (Index t = 0; t < mesh.tets.size(); ++t) {
        for (int corner = 0; corner < 4; ++corner) {
            Exchange exchange;
            if (!plan_face_removal(work, t, corner, best.least, exchange)) continue;
            best = exchange;
            is_found = true;
        }
    }
    if (is_found) (void)apply(work, best);
    return take_mesh(work);
}

TEST(FaceRemoval, FacesOfTheSurfaceStay) {
    const TetMesh mesh = small::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}, 4);
    const WorkMesh work(mesh);
    Exchange exchange;
    for (int corner = 0; corner < 4; ++corner) EXPECT_FALSE(plan_face_removal(work, 0, corner, 0, exchange));
}

TEST(FaceRemoval, TwoToThreeFillsTheSameSpace) {
    const TetMesh mesh = small::double_fan(3, 1.5);
    bool is_found = false;
    const TetMesh removed = remove_best(mesh, 0, is_found);
    ASSERT_TRUE(is_found);
    EXPECT_EQ(removed.tets.size(), 3u);
    EXPECT_TRUE(small::is_all_positive(removed));
    EXPECT_NEAR(small::volume_of(removed), small::volume_of(mesh), 1e-12);
    EXPECT_NE(WorkMesh(removed).complex.find_edge(0, 1), none);
}

TEST(FaceRemoval, SeveralFacesGoAtOnceWhereOneWouldNotDo) {
    for (int n = 4; n <= 5; ++n) {
        const TetMesh mesh = small::double_fan(n, 0.9);
        bool is_found = false;
        const TetMesh removed = remove_best(mesh, small::worst_of(mesh), is_found);
        ASSERT_TRUE(is_found) << n;
        EXPECT_EQ(removed.tets.size(), static_cast<std::size_t>(n));
        EXPECT_TRUE(small::is_all_positive(removed));
        EXPECT_NEAR(small::volume_of(removed), small::volume_of(mesh), 1e-12);
        EXPECT_GT(small::worst_of(removed), small::worst_of(mesh));
    }
}

TEST(FaceRemoval, AFaceBetweenTwoMaterialsStays) {
    TetMesh mesh = small::double_fan(3, 1.5);
    mesh.region[1] = 1;
    bool is_found = false;
    (void)remove_best(mesh, 0, is_found);
    EXPECT_FALSE(is_found);
}

TEST(FaceRemoval, AnEdgeThatWouldLeaveTheTwoTetsIsRefused) {
    TetMesh mesh = small::double_fan(3, 1.5);
    mesh.positions[0] = {5, 5, -0.5};
    bool is_found = false;
    (void)remove_best(mesh, 0, is_found);
    EXPECT_FALSE(is_found);
}

}
}
