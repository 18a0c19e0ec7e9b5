// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/bind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.h"
#include "cull/cull.h"
#include "delaunay/delaunay.h"
#include "mesh/shapes.h"

namespace crumple::bind {
namespace {

TetMesh tets_of(const Shell& shell, std::vector<Vec3> interior = {}) {
    PointSet points = shapes::points_of(shell);
    points.positions.insert(points.positions.end(), interior.begin(), interior.end());
    return cull::cull_outside(shell, delaunay::tetrahedralize(points).mesh).mesh;
}

VisualMesh visual_of(std::vector<Vec3> positions, std::string owner = "") {
    VisualMesh visual;
    visual.name = "paint";
    for (Vec3& p : positions) p = round_to_float(p);
    visual.positions = std::move(positions);
    visual.shell_component = std::move(owner);
    return visual;
}

Result bind(const Shell& shell, const TetMesh& mesh, const VisualMesh& visual, const Params& params = {},
            const Context& context = {}) {
    return bind_visuals(shell, mesh, std::span(&visual, 1), params, context);
}

bool has(const Report& report, const std::string& code) {
    return std::any_of(report.findings.begin(), report.findings.end(),
                       [&](const Finding& f) { return f.code == code; });
}

Vec3 place(const TetMesh& mesh, const VisualBinding& binding, Index v) {
    Vec3 sum;
    for (int i = 0; i < 4; ++i) sum += mesh.positions[mesh.tets[binding.tet[v]][i]] * binding.barycentric[v][i];
    return sum;
}

std::vector<Vec3> cloud(std::uint64_t seed, int count, double low, double high) {
    Rng rng(seed);
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const double x = low + (high - low) * rng.next_unit();
        const double y = low + (high - low) * rng.next_unit();
        points.push_back({x, y, low + (high - low) * rng.next_unit()});
    }
    return points;
}

TEST(Bind, NoVisualsAndEmptyVisualsAreFine) {
    const Shell shell = shapes::box();
    const TetMesh mesh = tets_of(shell);
    EXPECT_TRUE(bind_visuals(shell, mesh, {}).bindings.empty());
    const Result result = bind(shell, mesh, visual_of({}));
    ASSERT_EQ(result.bindings.size(), 1u);
    EXPECT_TRUE(result.bindings[0].tet.empty());
    EXPECT_EQ(result.report.visuals[0].vertices, 0u);
    EXPECT_TRUE(bind(shell, TetMesh{}, visual_of({})).bindings[0].tet.empty());
}

TEST(Bind, WithoutTetsOrWithBrokenPositionsItIsRefused) {
    const Shell shell = shapes::box();
    EXPECT_THROW((void)bind(shell, TetMesh{}, visual_of({{0, 0, 0}})), Error);
    VisualMesh broken = visual_of({{0, 0, 0}, {0, 0, 0}});
    broken.positions[1].z = std::numeric_limits<double>::quiet_NaN();
    try {
        (void)bind(shell, tets_of(shell), broken);
        FAIL() << "a vertex that is nowhere was bound";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_input);
        EXPECT_NE(std::string(error.what()).find("'paint': vertex 1"), std::string::npos);
    }
}

TEST(Bind, EveryVertexIsWhereItsWeightsSay) {
    const Shell shell = shapes::torus(1, 0.4, 24, 12);
    const TetMesh mesh = tets_of(shell, {{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}});
    const VisualMesh visual = visual_of(cloud(1, 3000, -1.6, 1.6));
    const Result result = bind(shell, mesh, visual);
    const VisualBinding& binding = result.bindings[0];
    std::uint64_t outside = 0;
    for (Index v = 0; v < visual.positions.size(); ++v) {
        double sum = 0;
        double largest = 1;
        for (const double w : binding.barycentric[v]) {
            sum += w;
            largest = std::max(largest, std::fabs(w));
            if (binding.inside[v]) {
                EXPECT_GE(w, 0);
            }
        }
        EXPECT_NEAR(sum, 1, 1e-13 * largest);
        EXPECT_LT(length(place(mesh, binding, v) - visual.positions[v]), 1e-12 * largest);
        EXPECT_EQ(binding.inside[v] != 0, binding.distance[v] == 0);
        outside += !binding.inside[v];
    }
    EXPECT_EQ(result.report.outside, outside);
    EXPECT_EQ(result.report.visuals[0].outside, outside);
    EXPECT_GT(outside, 500u);
}

TEST(Bind, ShellVerticesHangOnThemselves) {
    const Shell shell = shapes::icosphere(1, 2);
    const TetMesh mesh = tets_of(shell, {{0, 0, 0}});
    const Result result = bind(shell, mesh, visual_of(shell.positions));
    EXPECT_EQ(result.report.outside, 0u);
    for (Index v = 0; v < shell.positions.size(); ++v) {
        const Tet& tet = mesh.tets[result.bindings[0].tet[v]];
        const auto corner = std::find(tet.begin(), tet.end(), v) - tet.begin();
        ASSERT_LT(corner, 4);
        EXPECT_EQ(result.bindings[0].barycentric[v][corner], 1);
    }
}

TEST(Bind, FarVerticesAreNamedWorstFirst) {
    const Shell shell = shapes::box();
    const TetMesh mesh = tets_of(shell);
    const Result result =
        bind(shell, mesh, visual_of({{0.5, 0.5, 0.5}, {0.5, 0.5, 4}, {0.5, 0.5, 9}, {0.5, 0.5, 1.001}}));
    EXPECT_EQ(result.report.extrapolated, 2u);
    EXPECT_GT(result.report.max_weight, 5);
    EXPECT_DOUBLE_EQ(result.report.max_distance, 8);
    ASSERT_TRUE(has(result.report, "BIND_EXTRAPOLATED"));
    const Finding& finding = result.report.findings[0];
    EXPECT_EQ(finding.count, 2u);
    EXPECT_EQ(finding.places[0].element, 2u);
    EXPECT_EQ(finding.places[1].element, 1u);
    EXPECT_EQ(finding.places[0].name, "paint");
    Params relaxed;
    relaxed.max_weight = 100;
    EXPECT_TRUE(bind(shell, mesh, visual_of({{0.5, 0.5, 9}}), relaxed).report.findings.empty());
}

TEST(Bind, TheNamedComponentOwnsAllOfAMesh) {
    const Shell shell = shapes::nested_boxes(Role::rigid);
    const TetMesh mesh = tets_of(shell);
    const std::vector<Vec3> positions{{1.5, 1.5, 1.5}, {0.5, 1.5, 1.5}, {-1, 0, 0}, {2.5, 2.5, 2.5}};
    for (const auto& [name, region] : {std::pair{"inner", 1u}, {"outer", 0u}}) {
        const Result result = bind(shell, mesh, visual_of(positions, name));
        for (const Index t : result.bindings[0].tet) EXPECT_EQ(mesh.region[t], region);
        EXPECT_EQ(result.report.visuals[0].owner, name);
        }
    const Result free = bind(shell, mesh, visual_of(positions));
    EXPECT_EQ(mesh.region[free.bindings[0].tet[0]], 1u);
    EXPECT_EQ(mesh.region[free.bindings[0].tet[1]], 0u);
    EXPECT_EQ(free.report.outside, 1u);
}

TEST(Bind, OnABorderTheInnermostComponentOwns) {
    const Shell shell = shapes::nested_boxes(Role::rigid);
    const TetMesh mesh = tets_of(shell);
    const Result result = bind(shell, mesh, visual_of({{1, 1, 1}, {1, 1.5, 1.5}, {1.25, 1.75, 2}, {2, 2, 1.5}}));
    for (const Index t : result.bindings[0].tet) EXPECT_EQ(mesh.region[t], 1u);
}

TEST(Bind, AnOutsideVertexEquallyNearHangsOnItsOwnShell) {
    // Two boxes with one wall in common: above the wall's edge both are equally near.
    const Shell shell = shapes::joined(shapes::box({0, 0, 0}, {1, 1, 1}), shapes::box({1, 0, 0}, {3, 1, 1}));
    TetMesh mesh = shapes::tet_grid(2, {0, 0, 0}, {2, 1, 1});
    for (Index t = 0; t < mesh.tets.size(); ++t) mesh.region.push_back(t < 24 ? 0 : 1);
    const Result result = bind(shell, mesh, visual_of({{2.5, 0.5, 0.5}, {2.5, 0.25, 0.75}}));
    for (const Index t : result.bindings[0].tet) EXPECT_EQ(mesh.region[t], 1u);
}

TEST(Bind, UnknownOwnersAndOwnersWithoutTetsAreReported) {
    const Shell shell = shapes::nested_boxes(Role::cavity);
    const TetMesh mesh = tets_of(shell);
    const Result unknown = bind(shell, mesh, visual_of({{0.5, 0.5, 0.5}}, "door"));
    EXPECT_TRUE(has(unknown.report, "BIND_UNKNOWN_OWNER"));
    EXPECT_EQ(unknown.report.outside, 0u);
    const Result empty = bind(shell, mesh, visual_of({{0.5, 0.5, 0.5}}, "inner"));
    EXPECT_TRUE(has(empty.report, "BIND_OWNER_WITHOUT_TETS"));
    EXPECT_EQ(empty.report.outside, 0u);
}

TEST(Bind, SeveralVisualsKeepTheirOrderAndNames) {
    const Shell shell = shapes::box();
    const TetMesh mesh = tets_of(shell);
    std::vector<VisualMesh> visuals{visual_of({{0.5, 0.5, 0.5}}), visual_of({{0.1, 0.1, 0.1}, {2, 2, 2}})};
    visuals[0].name = "glass";
    const Result result = bind_visuals(shell, mesh, visuals);
    ASSERT_EQ(result.bindings.size(), 2u);
    EXPECT_EQ(result.bindings[0].name, "glass");
    EXPECT_EQ(result.bindings[1].tet.size(), 2u);
    EXPECT_EQ(result.report.vertices, 3u);
    EXPECT_EQ(result.report.visuals[1].outside, 1u);
}

TEST(Bind, ScaleDoesNotMatter) {
    const Shell torus = shapes::torus(1, 0.4, 16, 8);
    const std::vector<Vec3> positions = cloud(5, 500, -1.6, 1.6);
    const Result plain = bind(torus, tets_of(torus), visual_of(positions));
    for (const double scale : {0x1p-20, 0x1p14}) {
        const Shell shell = shapes::moved(torus, {}, scale);
        VisualMesh visual = visual_of(positions);
        for (Vec3& p : visual.positions) p = p * scale;
        EXPECT_EQ(bind(shell, tets_of(shell), visual).bindings[0].tet, plain.bindings[0].tet);
    }
}

TEST(Bind, ThreadsAndTheOrderOfVerticesDoNotChangeABit) {
    const Shell shell = shapes::joined(shapes::torus(1, 0.4, 24, 12), shapes::icosphere(0.5, 2, {0, 1, 0}));
    const TetMesh mesh = tets_of(shell);
    VisualMesh visual = visual_of(cloud(7, 20000, -1.6, 1.6));
    Context eight;
    eight.jobs = 8;
    const Result one = bind(shell, mesh, visual);
    const Result many = bind(shell, mesh, visual, {}, eight);
    EXPECT_EQ(one.bindings[0].tet, many.bindings[0].tet);
    EXPECT_EQ(one.bindings[0].barycentric, many.bindings[0].barycentric);
    EXPECT_EQ(one.bindings[0].distance, many.bindings[0].distance);
    std::reverse(visual.positions.begin(), visual.positions.end());
    const Result reversed = bind(shell, mesh, visual);
    for (Index v = 0; v < visual.positions.size(); ++v) {
        EXPECT_EQ(reversed.bindings[0].tet[v], one.bindings[0].tet[visual.positions.size() - 1 - v]);
    }
}

TEST(Bind, ACancelledRunStops) {
    std::atomic<bool> cancelled = true;
    Context context;
    context.cancelled = &cancelled;
    const Shell shell = shapes::box();
    EXPECT_THROW((void)bind(shell, tets_of(shell), visual_of({{0.5, 0.5, 0.5}}), {}, context), Error);
}

}
}
