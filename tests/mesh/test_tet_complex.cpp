// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tet_complex.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"
#include "geometry/predicates.h"
#include "mesh/neighbours.h"
#include "mesh/shapes.h"
#include "mesh/validate.h"

namespace crumple {
namespace {

Index interior_tet(const TetComplex& complex) {
    for (Index t = 0; t < complex.slot_count(); ++t) {
        bool all = true;
        for (int i = 0; i < 4; ++i) all = all && complex.neighbour(t, i) != none;
        if (all) return t;
    }
    return none;
}

void expect_sound(const TetComplex& complex) {
    const TetMesh mesh = complex.to_mesh();
    for (const Finding& finding : validate(mesh)) ADD_FAILURE() << finding.code << ": " << finding.message;
    EXPECT_EQ(mesh.neighbours, neighbours_of(mesh.tets));
    EXPECT_EQ(mesh.tets.size(), complex.tet_count());
    std::vector<std::uint8_t> used(mesh.positions.size(), 0);
    for (const Tet& tet : mesh.tets) {
        for (const Index v : tet) used[v] = 1;
    }
    for (Index v = 0; v < used.size(); ++v) {
        ASSERT_EQ(complex.tet_at(v) != none, used[v] != 0);
        if (used[v]) {
            EXPECT_GE(complex.corner_of(complex.tet_at(v), v), 0);
        }
    }
}

TEST(TetComplex, GivesBackTheMeshItWasMadeFrom) {
    const TetMesh mesh = shapes::tet_grid(3);
    const TetMesh out = TetComplex(mesh).to_mesh();
    EXPECT_EQ(out.tets, mesh.tets);
    EXPECT_EQ(out.neighbours, mesh.neighbours);
    EXPECT_EQ(out.positions, mesh.positions);
}

TEST(TetComplex, AnEmptyMeshIsNoTrouble) {
    const TetComplex complex{TetMesh{}};
    EXPECT_EQ(complex.slot_count(), 0u);
    EXPECT_TRUE(complex.to_mesh().tets.empty());
}

TEST(TetComplex, StarsHoldEveryTetOfTheirNode) {
    const TetMesh mesh = shapes::tet_grid(3);
    const TetComplex complex(mesh);
    std::vector<Index> star;
    for (Index v = 0; v < mesh.positions.size(); ++v) {
        complex.star_of(v, star);
        const auto expected = std::count_if(mesh.tets.begin(), mesh.tets.end(), [&](const Tet& tet) {
            return std::find(tet.begin(), tet.end(), v) != tet.end();
        });
        EXPECT_EQ(static_cast<std::ptrdiff_t>(star.size()), expected);
        for (const Index t : star) EXPECT_GE(complex.corner_of(t, v), 0);
    }
}

TEST(TetComplex, RingsRunAroundTheirEdgeInPositiveOrder) {
    const TetMesh mesh = shapes::tet_grid(3);
    const TetComplex complex(mesh);
    TetRing ring;
    std::size_t closed = 0;
    for (Index t = 0; t < mesh.tets.size(); ++t) {
        for (const auto& [i, j] : tet_edge_corners) {
            const Index a = mesh.tets[t][i];
            const Index b = mesh.tets[t][j];
            complex.ring_of(t, a, b, ring);
            closed += ring.is_closed;
            const auto expected = std::count_if(mesh.tets.begin(), mesh.tets.end(), [&](const Tet& tet) {
                return std::find(tet.begin(), tet.end(), a) != tet.end() &&
                       std::find(tet.begin(), tet.end(), b) != tet.end();
            });
            ASSERT_EQ(static_cast<std::ptrdiff_t>(ring.tets.size()), expected);
            ASSERT_EQ(ring.link.size(), ring.tets.size() + (ring.is_closed ? 0 : 1));
            for (std::size_t k = 0; k < ring.tets.size(); ++k) {
                const Index y = ring.link[k];
                const Index z = ring.link[(k + 1) % ring.link.size()];
                EXPECT_GE(complex.corner_of(ring.tets[k], y), 0);
                EXPECT_GE(complex.corner_of(ring.tets[k], z), 0);
                EXPECT_GT(orient3d(mesh.positions[a], mesh.positions[b], mesh.positions[y], mesh.positions[z]), 0);
            }
        }
    }
    EXPECT_GT(closed, 0u);
}

TEST(TetComplex, FindsEdgesAndFacesThatAreThereAndNoOthers) {
    const TetMesh mesh = shapes::tet_grid(2);
    const TetComplex complex(mesh);
    const auto& [a, b, c, d] = mesh.tets[5];
    EXPECT_NE(complex.find_edge(a, d), none);
    EXPECT_NE(complex.find_face(c, a, d), none);
    EXPECT_EQ(complex.find_edge(0, 26), none);  // corners of the box of two cells
    EXPECT_EQ(complex.find_face(0, 1, 26), none);
}

TEST(TetComplex, ANodeInsideATetSplitsItInFour) {
    TetComplex complex(shapes::tet_grid(3));
    const Index t = interior_tet(complex);
    const Tet tet = complex.corners(t);
    Vec3 middle;
    for (const Index v : tet) middle += complex.position(v) * 0.25;
    const Index x = complex.add_node(round_to_float(middle));
    EXPECT_EQ(complex.tet_at(x), none);
    const Tet parts[] = {{x, tet[1], tet[2], tet[3]},
                         {tet[0], x, tet[2], tet[3]},
                         {tet[0], tet[1], x, tet[3]},
                         {tet[0], tet[1], tet[2], x}};
    const std::vector<Index> slots = [&] {
        const auto fresh = complex.replace(std::array{t}, parts);
        return std::vector<Index>(fresh.begin(), fresh.end());
    }();
    EXPECT_EQ(slots.front(), t) << "the slot is used again";
    expect_sound(complex);
    complex.replace(slots, std::array<Tet, 1>{tet});
    EXPECT_EQ(complex.tet_at(x), none);
    expect_sound(complex);
}

TEST(TetComplex, TetsTakenAwayLeaveASurface) {
    TetComplex complex(shapes::tet_grid(2));
    Rng random(7, 0);
    for (int step = 0; step < 40; ++step) {
        Index t = random.next_below(complex.slot_count());
        while (!complex.is_tet(t)) t = (t + 1) % complex.slot_count();
        complex.replace(std::array{t}, {});
        expect_sound(complex);
    }
    EXPECT_EQ(complex.tet_count(), 8u);
}

TEST(TetComplex, RegionsStayWithTheirTets) {
    TetMesh mesh = shapes::tet_grid(2);
    mesh.region.assign(mesh.tets.size(), 3);
    TetComplex complex(mesh);
    const Tet tet = complex.corners(0);
    complex.replace(std::array<Index, 1>{0}, std::array<Tet, 1>{tet}, 5);
    EXPECT_EQ(complex.region(0), 5u);
    EXPECT_EQ(complex.region(1), 3u);
    EXPECT_EQ(complex.to_mesh().region[0], 5u);
}

}
}
