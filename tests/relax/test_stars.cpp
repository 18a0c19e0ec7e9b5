// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/stars.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "filled_shell.h"
#include "mesh/shapes.h"

using namespace crumple;
using namespace crumple::relax;

namespace {

TEST(Stars, AMeshWithoutInteriorNodesHasNone) {
    const TetMesh mesh = delaunay::tetrahedralize(shapes::points_of(shapes::box())).mesh;
    const Stars stars = find_stars(mesh, std::vector<std::uint8_t>(mesh.tets.size(), 1));
    EXPECT_EQ(stars.start.size(), 1u);
    EXPECT_TRUE(stars.tets.empty());
}

TEST(Stars, HoldTheTetsInsideAndKnowWhetherThatIsAll) {
    const TetMesh mesh = shapes::filled(shapes::subdivided_box(3), "40");
    ASSERT_GT(mesh.positions.size(), mesh.shell_vertex_count);
    std::vector<std::uint8_t> is_inside(mesh.tets.size(), 1);
    is_inside[mesh.tets.size() / 2] = 0;
    const Stars stars = find_stars(mesh, is_inside);
    for (Index node = mesh.shell_vertex_count; node < mesh.positions.size(); ++node) {
        std::vector<Index> expected;
        bool is_whole = true;
        for (Index t = 0; t < mesh.tets.size(); ++t) {
            if (std::find(mesh.tets[t].begin(), mesh.tets[t].end(), node) == mesh.tets[t].end()) continue;
            if (is_inside[t]) expected.push_back(t);
            is_whole = is_whole && is_inside[t];
        }
        const auto found = stars.of(node - mesh.shell_vertex_count);
        EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
        EXPECT_EQ(stars.is_whole[node - mesh.shell_vertex_count] != 0, is_whole);
    }
}

}
