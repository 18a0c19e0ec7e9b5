// SPDX-License-Identifier: GPL-3.0-or-later
#include "relax/relax.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "core/error.h"
#include "filled_shell.h"
#include "geometry/predicates.h"
#include "mesh/shapes.h"
#include "mesh/shell_interior.h"
#include "mesh/validate.h"

using namespace crumple;
using namespace crumple::relax;

namespace {

Params with(Method method, int sweeps = 20) {
    Params params;
    params.method = method;
    params.sweeps = sweeps;
    return params;
}

constexpr Method all_methods[] = {Method::cpt, Method::odt, Method::lloyd};

bool has_finding(const Report& report, const std::string& code) {
    return std::any_of(report.findings.begin(), report.findings.end(),
                       [&](const Finding& f) { return f.code == code; });
}

// Exact in-sphere test of each tet against the node across each face: enough for the whole mesh to be Delaunay.
std::size_t sphere_violations(const TetMesh& mesh) {
    std::size_t violations = 0;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        const auto& [a, b, c, d] = mesh.tets[t];
        for (const Index neighbour : mesh.neighbours[t]) {
            if (neighbour == none) continue;
            for (const Index v : mesh.tets[neighbour]) {
                if (v == a || v == b || v == c || v == d) continue;
                const auto& p = mesh.positions;
                violations += in_sphere(p[a], p[b], p[c], p[d], p[v]) > 0 ? 1 : 0;
            }
        }
    }
    return violations;
}

// The sample car in small: a body with a wheel house cut out of it would do as well; here two overlapping parts and a
// cavity.
Shell car_like() {
    Shell body = shapes::subdivided_box(7, {0, 0, 0}, {4, 1, 2});
    const Shell cabin = shapes::inverted(shapes::subdivided_box(3, {1, 0.3125, 0.5}, {2.5, 0.6875, 1.5}));
    Shell shell = shapes::joined(body, cabin);
    shell.components[1].role = Role::cavity;
    return shell;
}

TEST(Relax, AMeshWithoutInteriorNodesStaysAsItIs) {
    const Shell box = shapes::subdivided_box(3);
    const TetMesh mesh = shapes::filled(box, "0");
    const Result result = relax_points(mesh, box);
    EXPECT_EQ(result.mesh.positions, mesh.positions);
    EXPECT_EQ(result.mesh.tets, mesh.tets);
    EXPECT_TRUE(result.report.converged);
    EXPECT_EQ(result.report.sweeps_run, 0);
    EXPECT_EQ(result.report.history.size(), 1u);
}

TEST(Relax, AMeshWithoutTetsIsNoTrouble) {
    Shell flat = shapes::tetrahedron();
    flat.positions[3] = {1, 1, 0};
    TetMesh mesh;
    mesh.positions = flat.positions;
    mesh.positions.push_back({0.25, 0.25, 0});
    mesh.shell_vertex_count = 4;
    const Result result = relax_points(mesh, flat);
    EXPECT_EQ(result.mesh.positions, mesh.positions);
    EXPECT_EQ(result.report.after.tets, 0u);
}

TEST(Relax, ZeroSweepsReturnTheMesh) {
    const Shell box = shapes::subdivided_box(3);
    const TetMesh mesh = shapes::filled(box, "30");
    const Result result = relax_points(mesh, box, with(Method::cpt, 0));
    EXPECT_EQ(result.mesh.positions, mesh.positions);
    EXPECT_FALSE(result.report.converged);
    EXPECT_EQ(result.report.before.p5_dihedral_deg, result.report.after.p5_dihedral_deg);
}

TEST(Relax, AMeshOfAnotherShellIsRefused) {
    const TetMesh mesh = shapes::filled(shapes::subdivided_box(3), "5");
    EXPECT_THROW((void)relax_points(mesh, shapes::box()), Error);
    EXPECT_THROW((void)relax_points(mesh, shapes::subdivided_box(3, {0, 0, 0}, {1, 1, 2})), Error);
}

TEST(Relax, ShellVerticesStayAndTheMeshIsDelaunayAfterEachMethod) {
    const Shell shell = car_like();
    const TetMesh mesh = shapes::filled(shell, "150");
    for (const Method method : all_methods) {
        const Result result = relax_points(mesh, shell, with(method));
        EXPECT_TRUE(std::equal(shell.positions.begin(), shell.positions.end(), result.mesh.positions.begin()));
        EXPECT_EQ(result.mesh.positions.size(), mesh.positions.size());
        EXPECT_NE(result.mesh.positions, mesh.positions);
        EXPECT_EQ(sphere_violations(result.mesh), 0u);
        EXPECT_TRUE(validate(result.mesh).empty());
        const PointSet points{result.mesh.positions, result.mesh.shell_vertex_count};
        EXPECT_EQ(delaunay::tetrahedralize(points).mesh.tets, result.mesh.tets);
    }
}

TEST(Relax, NodesStayInTheirMaterialOnFloats) {
    for (const Shell& shell : {car_like(), shapes::torus(), shapes::nested_boxes(Role::rigid)}) {
        const ShellInterior interior(shell);
        const TetMesh mesh = shapes::filled(shell, "120");
        for (const Method method : all_methods) {
            const Result result = relax_points(mesh, shell, with(method));
            for (std::size_t v = mesh.shell_vertex_count; v < mesh.positions.size(); ++v) {
                const Vec3 p = result.mesh.positions[v];
                EXPECT_EQ(round_to_float(p), p);
                EXPECT_EQ(interior.material_at(p), interior.material_at(mesh.positions[v]));
            }
        }
    }
}

TEST(Relax, ShapesGetBetterFromRandomPoints) {
    const Shell shell = shapes::icosphere(1, 3);
    const TetMesh mesh = shapes::filled(shell);
    for (const Method method : all_methods) {
        const Report report = relax_points(mesh, shell, with(method)).report;
        EXPECT_GT(report.after.median_dihedral_deg, report.before.median_dihedral_deg + 5);
        EXPECT_LT(report.after.below_10_deg, report.before.below_10_deg / 2);
        EXPECT_GT(report.after.p5_dihedral_deg, report.before.p5_dihedral_deg);
    }
}

TEST(Relax, TheBestSweepIsKept) {
    const Shell shell = car_like();
    const Report report = relax_points(shapes::filled(shell, "150"), shell).report;
    ASSERT_EQ(report.history.size(), static_cast<std::size_t>(report.sweeps_run) + 1);
    const SweepReport& best = report.history[static_cast<std::size_t>(report.best_sweep)];
    for (const SweepReport& sweep : report.history) EXPECT_LE(best.below_10_deg, sweep.below_10_deg);
    EXPECT_EQ(best.below_10_deg, report.after.below_10_deg);
    EXPECT_EQ(best.p1_dihedral_deg, report.after.p1_dihedral_deg);
    EXPECT_EQ(best.p5_dihedral_deg, report.after.p5_dihedral_deg);
    EXPECT_EQ(report.history[0].below_10_deg, report.before.below_10_deg);
}

TEST(Relax, SmallMovesEndIt) {
    const Shell shell = shapes::icosphere(1, 2);
    Params params;
    params.sweeps = 1000;
    params.tolerance = 0.05;
    const Report report = relax_points(shapes::filled(shell), shell, params).report;
    EXPECT_TRUE(report.converged);
    EXPECT_LT(report.sweeps_run, 200);
    EXPECT_LE(report.history.back().max_move, 0.05);
    for (std::size_t i = 1; i + 1 < report.history.size(); ++i) EXPECT_GT(report.history[i].max_move, 0.05);
}

TEST(Relax, TetsThatBridgeAConcavityDoNotPullNodesOut) {
    // A torus: its hole is full of tets of the hull.
    const Shell shell = shapes::torus(1, 0.4, 32, 16);
    const TetMesh mesh = shapes::filled(shell, "200");
    double shell_volume = 0;
    for (const auto& [a, b, c] : shell.triangles) {
        shell_volume += dot(shell.positions[a], cross(shell.positions[b], shell.positions[c])) / 6;
    }
    for (const Method method : all_methods) {
        const Report report = relax_points(mesh, shell, with(method)).report;
        EXPECT_NEAR(report.after.volume, shell_volume, 0.03 * shell_volume);
    }
}

TEST(Relax, ANodeOutsideStaysAndIsNamed) {
    const Shell shell = shapes::subdivided_box(3);
    PointSet points = shapes::points_of(shell);
    points.positions.push_back({0.4375, 0.5, 0.5});
    points.positions.push_back({2, 2, 2});
    const Result result = relax_points(delaunay::tetrahedralize(points).mesh, shell);
    EXPECT_EQ(result.mesh.positions.back(), (Vec3{2, 2, 2}));
    ASSERT_TRUE(has_finding(result.report, "RELAX_NODE_OUTSIDE"));
    EXPECT_EQ(result.report.findings[0].count, 1u);
    EXPECT_EQ(result.report.findings[0].places[0].position, (Vec3{2, 2, 2}));
}

TEST(Relax, FlatTetsOfShellVerticesAreNamed) {
    const Shell shell = shapes::icosphere(1, 3);
    const Report report = relax_points(shapes::filled(shell), shell).report;
    EXPECT_EQ(report.shell_only_below_10_deg > 0, has_finding(report, "RELAX_SHELL_SLIVERS"));
    EXPECT_LE(report.shell_only_below_10_deg, report.after.below_10_deg);
}

TEST(Relax, OpenShellsAreRelaxedToo) {
    const Shell shell = shapes::without_triangle(shapes::icosphere(1, 2));
    const TetMesh mesh = shapes::filled(shell, "80");
    const ShellInterior interior(shell);
    const Result result = relax_points(mesh, shell);
    EXPECT_GE(result.report.sweeps_run, 1);
    for (const Vec3 p : shapes::interior_of(result.mesh)) EXPECT_NE(interior.material_at(p), none);
}

TEST(Relax, ScalingTheInputScalesTheResultExactly) {
    const Shell shell = shapes::torus();
    const TetMesh mesh = shapes::filled(shell, "100");
    for (const Method method : all_methods) {
        const Result result = relax_points(mesh, shell, with(method, 5));
        for (const double scale : {0x1p-20, 0x1p13}) {
            TetMesh scaled = mesh;
            for (Vec3& p : scaled.positions) p = p * scale;
            const Result other = relax_points(scaled, shapes::moved(shell, {}, scale), with(method, 5));
            EXPECT_EQ(other.mesh.tets, result.mesh.tets);
            for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                EXPECT_EQ(other.mesh.positions[v], result.mesh.positions[v] * scale);
            }
        }
    }
}

TEST(Relax, SameBytesForAnyNumberOfThreads) {
    const Shell shell = car_like();
    const TetMesh mesh = shapes::filled(shell, "150");
    const Result alone = relax_points(mesh, shell, with(Method::cpt, 6));
    for (const unsigned jobs : {2u, 8u}) {
        Context context;
        context.jobs = jobs;
        const Result together = relax_points(mesh, shell, with(Method::cpt, 6), context);
        EXPECT_EQ(alone.mesh.positions, together.mesh.positions);
        EXPECT_EQ(alone.mesh.tets, together.mesh.tets);
        EXPECT_EQ(alone.report.history.back().max_move, together.report.history.back().max_move);
    }
}

TEST(Relax, ACancelledRunStops) {
    std::atomic<bool> cancelled = true;
    Context context;
    context.cancelled = &cancelled;
    const Shell shell = shapes::icosphere();
    EXPECT_THROW((void)relax_points(shapes::filled(shell), shell, {}, context), Error);
}

struct Names {
    std::set<std::string> names;
    template <class T, class... Rest>
    void field(std::string_view name, T&, Rest...) {
        EXPECT_TRUE(names.insert(std::string(name)).second) << name;
    }
};

TEST(Relax, EveryFieldIsDescribedOnce) {
    Names names;
    Params params;
    describe(names, params);
    EXPECT_EQ(names.names.size(), 3u);
    names = {};
    Report report;
    describe(names, report);
    EXPECT_EQ(names.names.size(), 9u);
    names = {};
    SweepReport sweep;
    describe(names, sweep);
    EXPECT_EQ(names.names.size(), 7u);
}

}
