// SPDX-License-Identifier: GPL-3.0-or-later
#include "bake/bake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "bake/grid_input.h"
#include "bundle/validate.h"
#include "core/error.h"

using namespace crumple;
using test::bake_input;
using test::BakeInput;
using test::grid_input;

namespace {

const Finding* find_code(const std::vector<Finding>& findings, const std::string& code) {
    for (const Finding& finding : findings) {
        if (finding.code == code) return &finding;
    }
    return nullptr;
}

std::string refusal_of(const std::function<void(BakeInput&)>& damage) {
    BakeInput input = grid_input(2, 0);
    damage(input);
    try {
        (void)bake_input(input);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
        return error.what();
    }
    return "nothing";
}

Vec3 bound_position(const Bundle& b, const BundleVisual& visual, std::size_t v) {
    Vec3 p;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3f corner = b.rest_positions[b.tets[visual.tet[v]][k]];
        p += Vec3{corner.x, corner.y, corner.z} * double{visual.barycentric[v][k]};
    }
    return p;
}

}

TEST(Bake, RefusesInputsThatDoNotFitEachOther) {
    EXPECT_EQ(refusal_of([](BakeInput& i) {
                  i.mesh.tets.clear();
                  i.bindings.clear();
              }),
              "bake: the mesh has no tets");
    EXPECT_EQ(refusal_of([](BakeInput& i) { i.mesh.tets[5][2] = 27; }), "bake: tet 5 names a node that does not exist");
    EXPECT_EQ(refusal_of([](BakeInput& i) { std::swap(i.mesh.tets[5][2], i.mesh.tets[5][3]); }),
              "bake: tet 5 is flat or inside out");
    EXPECT_EQ(refusal_of([](BakeInput& i) { i.mesh.positions[26].x += 1e-12; }),
              "bake: node 26 lies where no float does");
    EXPECT_EQ(refusal_of([](BakeInput& i) { i.mesh.positions[3].x += 0.125; }),
              "bake: node 3 is not where the shell's vertex is");
    EXPECT_EQ(refusal_of([](BakeInput& i) { i.mesh.region = {0}; }), "bake: the mesh needs one region a tet");
    EXPECT_EQ(refusal_of([](BakeInput& i) { i.mesh.region.assign(i.mesh.tets.size(), 1); }),
              "bake: tet 0 lies in a component that does not exist");
    EXPECT_EQ(refusal_of([](BakeInput& i) { i.asset.shell.locked.clear(); }),
              "bake: the shell needs one lock flag a vertex");
    const std::string unbound =
        "bake: vertex 7 of visual mesh 'paint' is bound to no tet, or lies too far from all of them; is the mesh in "
        "the shell's unit (--unit) and place?";
    EXPECT_EQ(refusal_of([](BakeInput& i) { i.bindings[0].tet[7] = 48; }), unbound);
    EXPECT_EQ(refusal_of([](BakeInput& i) { i.bindings[0].barycentric[7][0] = std::nan(""); }), unbound);
    EXPECT_EQ(refusal_of([](BakeInput& i) { i.bindings[0].inside.pop_back(); }),
              "bake: the bindings of 'paint' differ in length");
    EXPECT_EQ(refusal_of([](BakeInput& i) { i.bindings.push_back(i.bindings[0]); }),
              "bake: visual meshes need names of their own, 'paint' is empty or used twice");
    EXPECT_NE(refusal_of([](BakeInput& i) { i.mesh.tets.push_back(i.mesh.tets[0]); }).find("BUNDLE_FACE"),
              std::string::npos);
}

TEST(Bake, RefusesToLoseALock) {
    EXPECT_NE(refusal_of([](BakeInput& i) {
                  i.asset.locked_positions.push_back({0.5, 0.5, 0.25});
              }).find("a painted lock has no locked node at its position, first at (0.5, 0.5, 0.25)"),
              std::string::npos);
    EXPECT_NE(refusal_of([](BakeInput& i) { i.asset.locked_positions.pop_back(); }).find("nobody painted"),
              std::string::npos);
}

TEST(Bake, RefusesTetsTooSmallForFloat) {
    BakeInput input = grid_input(1);
    for (Vec3& p : input.mesh.positions) p = round_to_float(p * 1e-14);
    input.asset.shell.positions = input.mesh.positions;
    try {
        (void)bake_input(input);
        FAIL() << "a volume of 1e-43 is not a normal float";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("check the unit"), std::string::npos);
    }
}

TEST(Bake, HoldsFromAMicrometreToTenKilometres) {
    for (const double scale : {1e-6, 1.0, 1e4}) {
        BakeInput input = grid_input(2, 0);
        for (Vec3& p : input.mesh.positions) p = round_to_float(p * scale);
        for (Vec3& p : input.asset.shell.positions) p = round_to_float(p * scale);
        for (Vec3& p : input.asset.locked_positions) p = round_to_float(p * scale);
        const bake::Result result = bake_input(input);
        EXPECT_TRUE(validate(result.bundle).empty());
        EXPECT_NEAR(result.report.bundle.volume_m3 / (scale * scale * scale), 1, 1e-5) << scale;
    }
}

TEST(Bake, ResultPassesValidation) {
    const bake::Result result = bake_input(grid_input(4, 0.3));
    EXPECT_TRUE(validate(result.bundle).empty());
    EXPECT_TRUE(result.report.findings.empty());
    EXPECT_EQ(result.report.bundle.tets, 4u * 4 * 4 * 6);
    EXPECT_NEAR(result.report.bundle.mass_kg, 1000, 1e-3) << "a cubic metre of steel-like body";
    EXPECT_LT(result.report.max_inverse_error, 1e-6);
}

TEST(Bake, EveryPaintedPositionIsALockedNode) {
    const BakeInput input = grid_input(3, 0.4);
    const Bundle b = bake_input(input).bundle;
    std::set<std::array<float, 3>> locked;
    for (std::size_t node = 0; node < b.locked.size(); ++node) {
        if (b.locked[node])
            locked.insert({b.rest_positions[node].x, b.rest_positions[node].y, b.rest_positions[node].z});
    }
    EXPECT_EQ(locked.size(), input.asset.locked_positions.size());
    for (const Vec3 p : input.asset.locked_positions) {
        EXPECT_TRUE(locked.contains({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}));
    }
    EXPECT_EQ(b.locked_positions.size(), locked.size());
}

TEST(Bake, KeepsALockedShellVertexThatNoTetUsesAndSaysSo) {
    BakeInput input = grid_input(2, 0);
    const Index vertex = input.mesh.shell_vertex_count;
    // A locked and a free shell vertex above the cube, and a stray interior node.
    input.mesh.positions.insert(input.mesh.positions.begin() + vertex, {{0.5, 2, 0.5}, {0.5, 3, 0.5}});
    input.mesh.positions.push_back({0.5, 4, 0.5});
    input.mesh.shell_vertex_count += 2;
    for (Tet& tet : input.mesh.tets) {
        for (Index& node : tet) node += node >= vertex ? 2 : 0;
    }
    Shell& shell = input.asset.shell;
    shell.positions.insert(shell.positions.end(), {{0.5, 2, 0.5}, {0.5, 3, 0.5}});
    shell.locked.insert(shell.locked.end(), {0, 0});
    shell.components.push_back({"antenna", "", Role::solid, "", 0, true, false, none});
    shell.triangles.push_back({vertex, vertex + 1, vertex});
    shell.component.push_back(1);
    test::lock(input.asset, vertex);

    const bake::Result result = bake_input(input);
    EXPECT_EQ(result.report.dropped_shell, 1u);
    EXPECT_EQ(result.report.dropped_interior, 1u);
    EXPECT_EQ(result.report.bundle.unused_locked_nodes, 1u);
    const Finding* finding = find_code(result.report.findings, "LOCK_UNUSED");
    ASSERT_NE(finding, nullptr);
    EXPECT_EQ(finding->count, 1u);
    EXPECT_EQ(finding->places[0].position, (Vec3{0.5, 2, 0.5}));
    EXPECT_EQ(finding->places[0].name, "antenna");
    const Bundle& b = result.bundle;
    const Index node = b.mesh_to_node[vertex];
    ASSERT_NE(node, none);
    EXPECT_EQ(b.mass[node], 0);
    EXPECT_EQ(b.locked[node], 1);
    EXPECT_EQ(b.mesh_to_node[vertex + 1], none);
    EXPECT_EQ(b.mesh_to_node.back(), none);
    EXPECT_EQ(node, b.rest_positions.size() - 1) << "nodes without edges come last";
}

TEST(Bake, TetsWithoutAFreeNodeComeLast) {
    const Bundle b = bake_input(grid_input(4, 0.6)).bundle;
    EXPECT_LT(b.solver_tet_count, b.tets.size());
    for (std::size_t t = 0; t < b.tets.size(); ++t) {
        int locked = 0;
        for (const Index node : b.tets[t]) locked += b.locked[node];
        EXPECT_EQ(locked == 4, t >= b.solver_tet_count);
        EXPECT_EQ(b.tets[t][0], *std::min_element(b.tets[t].begin(), b.tets[t].end()));
        if (t > 0 && t != b.solver_tet_count) {
            EXPECT_LT(b.tets[t - 1], b.tets[t]);
        }
    }
}

TEST(Bake, BoundVerticesStayWhereTheyWere) {
    const BakeInput input = grid_input(3, 0.4);
    const Bundle b = bake_input(input).bundle;
    const VisualBinding& binding = input.bindings[0];
    for (std::size_t v = 0; v < binding.tet.size(); ++v) {
        Vec3 expected;
        for (std::size_t k = 0; k < 4; ++k)
            expected += input.mesh.positions[input.mesh.tets[binding.tet[v]][k]] * binding.barycentric[v][k];
        EXPECT_LT(length(bound_position(b, b.visuals[0], v) - expected), 1e-6)
            << "float rounding of weights of at most 1";
    }
}

TEST(Bake, NodeOrderOfTheInputMakesNoDifference) {
    const BakeInput input = grid_input(4, 0.3);
    const Bundle a = bake_input(input).bundle;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const Bundle b = bake_input(test::shuffled(input, seed)).bundle;
        EXPECT_EQ(a.rest_positions, b.rest_positions) << "seed " << seed;
        EXPECT_EQ(a.tets, b.tets);
        EXPECT_EQ(a.mass, b.mass);
        EXPECT_EQ(a.inverse_rest, b.inverse_rest);
        EXPECT_EQ(a.column, b.column);
        EXPECT_EQ(a.edge_tet, b.edge_tet);
        EXPECT_EQ(a.visuals[0].tet, b.visuals[0].tet);
        EXPECT_EQ(a.visuals[0].barycentric, b.visuals[0].barycentric);
    }
}

TEST(Bake, MinusZeroBecomesZero) {
    BakeInput input = grid_input(1);
    for (Vec3& p : input.mesh.positions) {
        if (p.x == 0) p.x = -0.0;
    }
    for (const Vec3f p : bake_input(input).bundle.rest_positions) EXPECT_FALSE(std::signbit(p.x));
}

TEST(Bake, EveryNodeOrderPasses) {
    for (const auto order : {bake::NodeOrder::rcm, bake::NodeOrder::axis, bake::NodeOrder::mesh}) {
        bake::Params params;
        params.node_order = order;
        EXPECT_TRUE(validate(bake_input(grid_input(3, 0.3), params).bundle).empty());
    }
}
