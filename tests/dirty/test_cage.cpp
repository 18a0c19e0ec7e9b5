// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/cage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "dirty/dirty_shell.h"
#include "importer/lattice.h"
#include "mesh/boundary.h"
#include "mesh/shapes.h"
#include "mesh/shell_interior.h"

namespace crumple {
namespace {

using test::cook_shell;
using test::Cooked;

importer::Params cells(std::uint32_t count) {
    importer::Params params;
    params.cage = count;
    return params;
}

Shell bowl() {
    Shell shell = shapes::icosphere(1, 3);
    std::erase_if(shell.triangles, [&](const Triangle& t) {
        return shell.positions[t[0]].y + shell.positions[t[1]].y + shell.positions[t[2]].y > 0;
    });
    shell.component.assign(shell.triangles.size(), 0);
    return shell;
}

TEST(Lattice, IsTheDelaunayTetrahedralizationOfItsNodes) {
    const importer::Lattice lattice = importer::make_lattice({{0, 0, 0}, {1, 0.5, 0.25}}, 4);
    EXPECT_TRUE(validate(lattice.mesh).empty());
    EXPECT_EQ(lattice.cell, 0.25);
    const TetMesh hull = delaunay::tetrahedralize({lattice.mesh.positions, 0}).mesh;
    const auto sets_of = [](const std::vector<Tet>& tets) {
        std::set<Tet> sets;
        for (Tet tet : tets) {
            std::sort(tet.begin(), tet.end());
            sets.insert(tet);
        }
        return sets;
    };
    const std::set<Tet> whole = sets_of(hull.tets);
    const std::set<Tet> own = sets_of(lattice.mesh.tets);
    EXPECT_TRUE(std::includes(whole.begin(), whole.end(), own.begin(), own.end()));
}

TEST(Cage, ABowlIsBuiltAroundAsAClosedManifold) {
    const Cooked cooked = cook_shell(bowl(), cells(10));
    ASSERT_EQ(cooked.refusal, "");
    EXPECT_TRUE(cooked.warns("IMPORT_CAGED"));
    EXPECT_EQ(test::fault_of(cooked), "");
    const Shell& cage = cooked.asset.shell;
    EXPECT_TRUE(non_manifold(cage.triangles).edges.empty());
    EXPECT_TRUE(non_manifold(cage.triangles).vertices.empty());
    const ShellInterior interior(cage);
    for (const Triangle& t : bowl().triangles) {
        const Shell old = bowl();
        const Vec3 middle = (old.positions[t[0]] + old.positions[t[1]] + old.positions[t[2]]) / 3.0;
        EXPECT_NE(interior.material_at(middle), none);
    }
    // The tets are the lattice's: nothing was added, nothing lost.
    EXPECT_EQ(cooked.sample.points, 0u);
    EXPECT_EQ(cooked.mesh.positions, cage.positions);
    EXPECT_NEAR(cooked.cull.volume, cage.components.at(0).volume, 1e-9);
    EXPECT_EQ(cooked.cull.non_manifold_edges, 0u);
}

TEST(Cage, EveryLockedVertexLiesInTetsThatCannotMove) {
    const Shell shell = bowl();
    const auto is_locked = [&](std::size_t v) { return shell.positions[v].y < -0.8; };
    const Cooked cooked = cook_shell(shell, cells(12), [&](std::size_t v) { return is_locked(v) ? 0.0 : 1.0; });
    ASSERT_EQ(cooked.refusal, "");
    const TetMesh& mesh = cooked.mesh;
    for (std::size_t v = 0; v < shell.positions.size(); ++v) {
        if (!is_locked(v)) continue;
        bool is_held = false;
        for (const Tet& tet : mesh.tets) {
            bool is_inside = true;
            bool is_fixed = true;
            for (int face = 0; face < 4; ++face) {
                const auto& [a, b, c] = tet_face_corners[face];
                is_inside = is_inside && orient3d(mesh.positions[tet[a]], mesh.positions[tet[b]],
                                                  mesh.positions[tet[c]], shell.positions[v]) <= 0;
                is_fixed = is_fixed && cooked.asset.shell.locked[tet[face]];
            }
            is_held = is_held || (is_inside && is_fixed);
        }
        EXPECT_TRUE(is_held) << v;
    }
    const auto locked = std::count(cooked.asset.shell.locked.begin(), cooked.asset.shell.locked.end(), 1);
    EXPECT_EQ(cooked.asset.locked_positions.size(), static_cast<std::size_t>(locked));
    EXPECT_LT(static_cast<std::size_t>(locked), cooked.asset.shell.positions.size());
}

TEST(Cage, HoldsTheVisualMeshesToo) {
    const test::TempFolder folder;
    const std::string visual = folder.write("visual.obj", test::obj_text(shapes::icosphere(0.2, 2, {0, 1.5, 0})));
    const importer::Result result =
        importer::import_asset({folder.write("bowl.obj", test::obj_text(bowl())), {{"", visual}}}, cells(10));
    const ShellInterior interior(result.asset.shell);
    for (const Vec3& p : result.asset.visuals.at(0).positions)
        EXPECT_TRUE(interior.material_at(p) != none || interior.is_on_surface(p));
}

TEST(Cage, AFlatSheetAndLooseTrianglesGetOneAsWell) {
    Shell square;
    square.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0.7}};
    square.triangles = {{0, 1, 2}};
    EXPECT_EQ(test::fault_of(cook_shell(square, cells(6))), "");
    square.triangles = {{0, 1, 2}, {2, 3, 0}, {0, 2, 4}};
    EXPECT_EQ(test::fault_of(cook_shell(square, cells(6))), "");
}

TEST(Cage, ScaleAndPlaceDoNotMatter) {
    const Cooked near = cook_shell(bowl(), cells(8));
    const Cooked small = cook_shell(shapes::moved(bowl(), {0, 0, 0}, 0x1p-10), cells(8));
    EXPECT_EQ(small.asset.shell.triangles, near.asset.shell.triangles);
    EXPECT_EQ(test::fault_of(cook_shell(shapes::moved(bowl(), {1000, 0, 0}), cells(8))), "");
    EXPECT_NE(cook_shell(shapes::moved(bowl(), {2e5, 0, 0}), cells(8)).refusal.find("too far"), std::string::npos);
}

}
}
