// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/components.h"

#include <cmath>

#include "importer/import_checks.h"
#include "importer/make_surface.h"
#include "importer/roles.h"
#include "mesh/shapes.h"

namespace crumple::importer {
namespace {

using test::add_object;
using test::find;
using test::surface_of;
using test::weld_unpainted;

struct Split {
    Shell shell;
    Components components;
    std::vector<Finding> findings;  // of the roles
};

// Locks every vertex with x >= locked_from.
Split split(const Surface& surface, const Params& params = {}, double locked_from = 1e9) {
    Split result;
    Welded welded = weld_unpainted(surface);
    result.components = split_components(surface, welded);
    result.shell.positions = welded.positions;
    result.shell.triangles = welded.triangles;
    result.shell.component = result.components.of_triangle;
    for (const Vec3 p : result.shell.positions) result.shell.locked.push_back(p.x >= locked_from);
    result.findings = assign_roles(surface, result.components, params, result.shell);
    return result;
}

double volume_of(const Shell& shell, Index component) {
    double volume = 0;
    for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
        const Triangle& c = shell.triangles[t];
        if (shell.component[t] != component) continue;
        volume += dot(shell.positions[c[0]], cross(shell.positions[c[1]], shell.positions[c[2]])) / 6;
    }
    return volume;
}

TEST(Components, OneBoxIsOneClosedComponent) {
    const Split result = split(surface_of(shapes::box()));
    ASSERT_EQ(result.shell.components.size(), 1u);
    const Component& box = result.shell.components[0];
    EXPECT_EQ(box.name, "thing");
    EXPECT_EQ(box.material, "paint");
    EXPECT_TRUE(box.is_closed);
    EXPECT_FALSE(box.is_inward);
    EXPECT_DOUBLE_EQ(box.volume, 1);
    EXPECT_EQ(box.role, Role::solid);
    EXPECT_TRUE(result.components.findings.empty());
    EXPECT_TRUE(result.findings.empty());
}

TEST(Components, AHoleIsReportedWhereItIs) {
    const Split result = split(surface_of(shapes::without_triangle(shapes::box(), 4)));
    EXPECT_FALSE(result.shell.components[0].is_closed);
    EXPECT_EQ(result.components.open_edges, 3u);
    const Finding* open = find(result.components.findings, "SHELL_OPEN");
    ASSERT_NE(open, nullptr);
    EXPECT_EQ(open->count, 3u);
    EXPECT_EQ(open->places.size(), 3u);
    EXPECT_EQ(open->places[0].name, "thing");
}

TEST(Components, TurnedTrianglesAreTurnedBack) {
    Shell shell = shapes::icosphere(1, 2);
    for (const std::size_t t : {3u, 4u, 77u}) std::swap(shell.triangles[t][1], shell.triangles[t][2]);
    const Split result = split(surface_of(shell));
    EXPECT_EQ(result.components.flipped, 3u);
    EXPECT_EQ(find(result.components.findings, "SHELL_INCONSISTENT")->count, 3u);
    EXPECT_TRUE(result.shell.components[0].is_closed);
    EXPECT_NEAR(volume_of(result.shell, 0), 4.0 / 3 * M_PI, 0.3);
    EXPECT_EQ(result.shell.triangles, shapes::icosphere(1, 2).triangles);
}

TEST(Components, AMoebiusBandIsReported) {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    const Index around = 12;
    for (Index i = 0; i < around; ++i) {
        const double angle = 2 * M_PI * i / around;
        for (const double side : {-0.3, 0.3}) {
            const double radius = 1 + side * std::cos(angle / 2);
            positions.push_back(
                round_to_float({radius * std::cos(angle), side * std::sin(angle / 2), radius * std::sin(angle)}));
        }
    }
    for (Index i = 0; i < around; ++i) {
        const Index a = 2 * i;
        const Index b = a + 1;
        const bool last = i + 1 == around;
        const Index c = last ? 1 : a + 2;
        const Index d = last ? 0 : a + 3;
        triangles.push_back({a, b, c});
        triangles.push_back({b, d, c});
    }
    const Split result = split(surface_of(positions, triangles));
    EXPECT_NE(find(result.components.findings, "SHELL_NOT_ORIENTABLE"), nullptr);
    EXPECT_FALSE(result.shell.components[0].is_closed);
}

TEST(Components, AFinIsNonManifold) {
    Shell shell = shapes::box();
    shell.positions.push_back({2, 2, 2});
    shell.triangles.push_back({shell.triangles[0][0], shell.triangles[0][1], 8});
    const Split result = split(surface_of(shell));
    EXPECT_EQ(result.components.non_manifold_edges, 1u);
    EXPECT_EQ(find(result.components.findings, "SHELL_NON_MANIFOLD")->count, 1u);
    EXPECT_FALSE(result.shell.components[0].is_closed);
}

// An engine that stands on the floor of the body shares its corners, and is still an engine.
TEST(Components, ClosedObjectsThatTouchStayApart) {
    Surface surface = surface_of(shapes::box());
    add_object(surface, surface_of(shapes::box({1, 0, 0}, {2, 1, 1})), "engine");
    const Split result = split(surface);
    ASSERT_EQ(result.shell.components.size(), 2u);
    EXPECT_EQ(result.shell.positions.size(), 12u);  // the wall is shared
    EXPECT_EQ(result.components.non_manifold_edges, 0u);
    EXPECT_TRUE(result.shell.components[1].is_closed);
    EXPECT_EQ(result.shell.components[1].name, "engine");
}

TEST(Components, OpenObjectsAreOneSurfaceTogether) {
    Shell half = shapes::box();
    Shell rest = half;
    half.triangles.resize(5);
    rest.triangles.erase(rest.triangles.begin(), rest.triangles.begin() + 5);
    Surface surface = surface_of(half);
    add_object(surface, surface_of(rest), "roof");
    const Split result = split(surface);
    ASSERT_EQ(result.shell.components.size(), 1u);
    EXPECT_TRUE(result.shell.components[0].is_closed);
    EXPECT_EQ(result.components.open_edges, 0u);
}

TEST(Roles, InwardInsideAnotherIsACavity) {
    const Shell shell =
        shapes::joined(shapes::box({0, 0, 0}, {3, 3, 3}), shapes::inverted(shapes::box({1, 1, 1}, {2, 2, 2})));
    const Split result = split(surface_of(shell));
    ASSERT_EQ(result.shell.components.size(), 2u);
    EXPECT_EQ(result.shell.components[1].role, Role::cavity);
    EXPECT_EQ(result.shell.components[1].parent, 0u);
    EXPECT_EQ(result.shell.components[1].role_reason, "winding: closed and wound inwards inside 'thing'");
    EXPECT_DOUBLE_EQ(volume_of(result.shell, 1), -1);
    EXPECT_EQ(find(result.findings, "SHELL_NESTED")->count, 1u);
    EXPECT_EQ(find(result.findings, "SHELL_INVERTED"), nullptr);
}

TEST(Roles, OutwardInsideAnotherIsSolid) {
    const Split result = split(surface_of(shapes::nested_boxes()));
    EXPECT_EQ(result.shell.components[1].role, Role::solid);
    EXPECT_EQ(result.shell.components[1].parent, 0u);
}

TEST(Roles, InwardInsideNothingIsTurned) {
    const Split result = split(surface_of(shapes::inverted(shapes::box())));
    EXPECT_EQ(result.shell.components[0].role, Role::solid);
    EXPECT_TRUE(result.shell.components[0].is_inward);
    EXPECT_DOUBLE_EQ(volume_of(result.shell, 0), 1);
    EXPECT_NE(find(result.findings, "SHELL_INVERTED"), nullptr);
}

TEST(Roles, SolidInTheCavityIsSolidHoweverWound) {
    Shell shell =
        shapes::joined(shapes::box({0, 0, 0}, {9, 9, 9}), shapes::inverted(shapes::box({1, 1, 1}, {8, 8, 8})));
    shell = shapes::joined(shell, shapes::inverted(shapes::box({3, 3, 3}, {4, 4, 4})));
    const Split result = split(surface_of(shell));
    ASSERT_EQ(result.shell.components.size(), 3u);
    EXPECT_EQ(result.shell.components[1].role, Role::cavity);
    EXPECT_EQ(result.shell.components[2].role, Role::solid);
    EXPECT_EQ(result.shell.components[2].parent, 1u);
    EXPECT_EQ(result.shell.components[2].role_reason,
              "winding: closed and wound inwards, but in the cavity 'thing.2'; turned");
    EXPECT_DOUBLE_EQ(volume_of(result.shell, 2), 1);
}

TEST(Roles, RecipeWinsByNameMeshOrMaterial) {
    Surface surface = surface_of(shapes::box({0, 0, 0}, {9, 9, 9}));
    add_object(surface, surface_of(shapes::box({1, 1, 1}, {2, 2, 2})), "engine");
    add_object(surface, surface_of(shapes::box({4, 4, 4}, {5, 5, 5})), "cage");
    add_object(surface, surface_of(shapes::box({6, 6, 6}, {7, 7, 7})), "cabin");
    Params params;
    params.roles = {
        {"engine", Role::rigid}, {"cage paint", Role::rigid}, {"cabin mesh", Role::cavity}, {"wheel", Role::rigid}};
    const Split result = split(surface, params);
    ASSERT_EQ(result.shell.components.size(), 4u);
    EXPECT_EQ(result.shell.components[1].role, Role::rigid);
    EXPECT_EQ(result.shell.components[1].role_reason, "recipe: component 'engine'");
    EXPECT_EQ(result.shell.components[2].role_reason, "recipe: material 'cage paint'");
    EXPECT_EQ(result.shell.components[3].role, Role::cavity);
    EXPECT_EQ(result.shell.components[3].role_reason, "recipe: mesh 'cabin mesh'");
    EXPECT_DOUBLE_EQ(volume_of(result.shell, 3), -1);
    const Finding* unknown = find(result.findings, "ROLE_UNKNOWN");
    ASSERT_NE(unknown, nullptr);
    EXPECT_TRUE(test::contains(unknown->message, "'wheel'")) << unknown->message;
    EXPECT_TRUE(test::contains(unknown->message, "'engine'")) << unknown->message;
}

TEST(Roles, PaintedAllOverInsideAnotherIsRigid) {
    Surface surface = surface_of(shapes::box({0, 0, 0}, {9, 9, 9}));
    add_object(surface, surface_of(shapes::box({4, 1, 1}, {5, 2, 2})), "engine");
    const Split engine = split(surface, {}, 4);
    EXPECT_EQ(engine.shell.components[0].role, Role::solid);
    EXPECT_EQ(engine.shell.components[1].role, Role::rigid);
    EXPECT_EQ(engine.shell.components[1].role_reason, "paint: every vertex is locked, inside 'thing'");
    EXPECT_EQ(split(surface, {}, 5).shell.components[1].role, Role::solid);

    const Split all = split(surface, {}, 0);
    EXPECT_EQ(all.shell.components[0].role, Role::solid);

    Params params;
    params.roles = {{"engine", Role::solid}};
    EXPECT_EQ(split(surface, params, 4).shell.components[1].role, Role::solid);
}

TEST(Roles, RecipeForAnObjectLeavesItsCavity) {
    const Shell shell =
        shapes::joined(shapes::box({0, 0, 0}, {3, 3, 3}), shapes::inverted(shapes::box({1, 1, 1}, {2, 2, 2})));
    Params params;
    params.roles = {{"thing", Role::rigid}};
    const Split by_object = split(surface_of(shell), params);
    EXPECT_EQ(by_object.shell.components[0].role, Role::rigid);
    EXPECT_EQ(by_object.shell.components[1].role, Role::cavity);
    params.roles = {{"thing.2", Role::solid}};
    const Split by_name = split(surface_of(shell), params);
    EXPECT_EQ(by_name.shell.components[1].role, Role::solid);
    EXPECT_DOUBLE_EQ(volume_of(by_name.shell, 1), 1);
}

TEST(Roles, NamesAreUnique) {
    Surface surface = surface_of(shapes::box());
    add_object(surface, surface_of(shapes::moved(shapes::box(), {5, 0, 0})), "thing");
    add_object(surface, surface_of(shapes::moved(shapes::box(), {0, 5, 0})), "thing.2");
    const Split result = split(surface);
    EXPECT_EQ(result.shell.components[0].name, "thing");
    EXPECT_EQ(result.shell.components[1].name, "thing.2");
    EXPECT_EQ(result.shell.components[2].name, "thing.2.2");
}

}
}
