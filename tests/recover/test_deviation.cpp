// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/deviation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/neighbours.h"
#include "mesh/shapes.h"

using namespace crumple;
using namespace crumple::recover;

namespace {

// Two tets over the square of the nodes 0, 1, 2, 3, whose mesh has the diagonal (1, 3); 0 and 2 lie `rise` higher.
TetMesh folded_square(double rise) {
    TetMesh mesh;
    mesh.positions = {{0, rise, 0}, {0, 0, 1}, {1, rise, 1}, {1, 0, 0}, {0.5, -2, 0.5}, {0.5, 2, 0.5}};
    mesh.tets = {{1, 3, 4, 0}, {1, 3, 2, 4}, {1, 3, 0, 5}, {1, 3, 5, 2}};
    for (Tet& t : mesh.tets) {
        const Vec3 a = mesh.positions[t[0]];
        if (dot(mesh.positions[t[1]] - a, cross(mesh.positions[t[2]] - a, mesh.positions[t[3]] - a)) < 0)
            std::swap(t[2], t[3]);
    }
    mesh.neighbours = neighbours_of(mesh.tets);
    return mesh;
}

TEST(Deviation, AnotherDiagonalOfAFlatSquareIsNone) {
    const TetComplex complex(folded_square(0));
    const std::vector<Index> apexes{1, 3};
    EXPECT_TRUE(is_covered(complex, Edge{0, 2}, apexes));
    EXPECT_EQ(deviation_of_segment(complex, {0, 2}, apexes), 0);
    EXPECT_TRUE(is_covered(complex, Triangle{0, 2, 1}));
}

TEST(Deviation, ABentSquareIsNotCovered) {
    const TetComplex complex(folded_square(0.01));
    const std::vector<Index> apexes{1, 3};
    EXPECT_FALSE(is_covered(complex, Edge{0, 2}, apexes));
    const double deviation = deviation_of_segment(complex, {0, 2}, apexes);
    EXPECT_GT(deviation, 0);
    EXPECT_LT(deviation, 0.03);
}

TEST(Deviation, AFoldToBeSeenIsNeverNegligible) {
    const TetComplex complex(folded_square(0.2));
    EXPECT_TRUE(std::isinf(deviation_of_segment(complex, {0, 2}, std::vector<Index>{1, 3})));
}

TEST(Deviation, TheRimOfASheetIsNeverNegligible) {
    const TetComplex complex(folded_square(0));
    EXPECT_TRUE(std::isinf(deviation_of_segment(complex, {0, 2}, std::vector<Index>{1})));
    EXPECT_TRUE(std::isinf(deviation_of_segment(complex, {0, 2}, std::vector<Index>{1, 3, 4})));
}

TEST(Deviation, OfAPiercedFacetItIsTheNearerEndsDistance) {
    // The edge (1, 3) passes through the facet (0, 2, 4), a unit away on both sides along the diagonal.
    const TetComplex complex(folded_square(0.01));
    EXPECT_NEAR(deviation_of_facet(complex, {0, 2, 4}), std::sqrt(0.5), 1e-6);
}

TEST(Deviation, SharesOfASegmentAreMeasuredFromItsFirstNode) {
    const TetComplex complex(folded_square(0));
    EXPECT_NEAR(crossing_share(complex, {0, 2}, {{1, 3, none}, 2, 0}), 0.5, 1e-12);
    EXPECT_NEAR(crossing_share(complex, {4, 5}, {{0, 1, 3}, 3, 0}), 0.5, 1e-12);
    EXPECT_NEAR(crossing_share(complex, {4, 5}, {{2, none, none}, 1, 0}), 0.5, 1e-12);
}

}
