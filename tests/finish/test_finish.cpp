// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/finish.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "cull/cull.h"
#include "delaunay/delaunay.h"
#include "mesh/shapes.h"
#include "mesh/validate.h"
#include "relax/relax.h"
#include "sample/read_obj_shell.h"
#include "sample/sample.h"
#include "small_meshes.h"

namespace crumple::finish {
namespace {

// The stages before this one.
TetMesh culled(const Shell& shell, const std::string& count = "auto") {
    sample::Params params;
    params.points = count;
    TetMesh mesh = delaunay::tetrahedralize(sample::sample_interior(shell, params).points).mesh;
    mesh = relax::relax_points(std::move(mesh), shell).mesh;
    return cull::cull_outside(shell, std::move(mesh)).mesh;
}

std::optional<Shell> shared_shell(const std::string& name) {
    return shapes::read_obj_shell(test::data_folder() / "quality" / (name + ".obj"));
}

void expect_sound(const Shell& shell, const TetMesh& mesh) {
    EXPECT_TRUE(validate(mesh, static_cast<Index>(shell.components.size())).empty());
    EXPECT_TRUE(small::is_all_positive(mesh));
    ASSERT_GE(mesh.positions.size(), shell.positions.size());
    EXPECT_TRUE(std::equal(shell.positions.begin(), shell.positions.end(), mesh.positions.begin()));
    EXPECT_EQ(mesh.shell_vertex_count, shell.positions.size());
    for (const Vec3& p : mesh.positions) EXPECT_EQ(p, round_to_float(p));
}

// A sheet 1 x thickness x 1 of cells x cells squares above and below, its rim one square high.
Shell plate(int cells, double thickness) {
    Shell shell;
    const auto number = [&](int i, int j, int side) { return static_cast<Index>((i * (cells + 1) + j) * 2 + side); };
    for (int i = 0; i <= cells; ++i) {
        for (int j = 0; j <= cells; ++j) {
            for (const double y : {0.0, thickness})
                shell.positions.push_back(round_to_float({double(i) / cells, y, double(j) / cells}));
        }
    }
    const auto add_square = [&](Index a, Index b, Index c, Index d) {
        shell.triangles.insert(shell.triangles.end(), {{a, b, c}, {a, c, d}});
    };
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            add_square(number(i, j, 0), number(i + 1, j, 0), number(i + 1, j + 1, 0), number(i, j + 1, 0));
            add_square(number(i, j, 1), number(i, j + 1, 1), number(i + 1, j + 1, 1), number(i + 1, j, 1));
        }
        const int n = cells;
        add_square(number(i, 0, 0), number(i, 0, 1), number(i + 1, 0, 1), number(i + 1, 0, 0));
        add_square(number(i, n, 0), number(i + 1, n, 0), number(i + 1, n, 1), number(i, n, 1));
        add_square(number(0, i, 0), number(0, i + 1, 0), number(0, i + 1, 1), number(0, i, 1));
        add_square(number(n, i, 0), number(n, i, 1), number(n, i + 1, 1), number(n, i + 1, 0));
    }
    shell.locked.assign(shell.positions.size(), 0);
    shell.component.assign(shell.triangles.size(), 0);
    shell.components.emplace_back().name = "sheet";
    shell.components[0].is_closed = true;
    shell.components[0].volume = thickness;
    return shell;
}

bool has(const Report& report, const std::string& code) {
    return std::any_of(report.findings.begin(), report.findings.end(),
                       [&](const Finding& f) { return f.code == code; });
}

std::vector<double> sorted_shapes(const TetMesh& mesh) {
    std::vector<double> shapes;
    for (const auto& [a, b, c, d] : mesh.tets)
        shapes.push_back(shape_of(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]));
    std::sort(shapes.begin(), shapes.end());
    return shapes;
}

TEST(Finish, AMeshWithoutTetsStaysOne) {
    for (const Mode mode : {Mode::none, Mode::peel, Mode::full}) {
        Params params;
        params.mode = mode;
        const Result result = finish_mesh({}, {}, params);
        EXPECT_TRUE(result.mesh.tets.empty());
        EXPECT_EQ(result.report.after.tets, 0u);
    }
}

TEST(Finish, AMeshOfAnotherShellIsABug) {
    const Shell shell = shapes::box();
    TetMesh mesh = culled(shell);
    mesh.positions[0].x = 7;
    EXPECT_THROW((void)finish_mesh(shell, mesh), Error);
    EXPECT_THROW((void)finish_mesh(shapes::tetrahedron(), culled(shell)), Error);
    mesh = culled(shell);
    mesh.neighbours.clear();
    EXPECT_THROW((void)finish_mesh(shell, mesh), Error);
}

TEST(Finish, ASingleTetHasNothingToMend) {
    const Shell shell = shapes::tetrahedron();
    const TetMesh mesh = culled(shell, "0");
    const Result result = finish_mesh(shell, mesh);
    EXPECT_EQ(result.mesh.tets, mesh.tets);
    EXPECT_EQ(result.mesh.positions, mesh.positions);
    EXPECT_EQ(result.report.volume_change, 0);
}

TEST(Finish, NoneLeavesEveryByte) {
    const Shell shell = shapes::icosphere(1, 2);
    const TetMesh mesh = culled(shell);
    Params params;
    params.mode = Mode::none;
    const Result result = finish_mesh(shell, mesh, params);
    EXPECT_EQ(result.mesh.tets, mesh.tets);
    EXPECT_EQ(result.mesh.neighbours, mesh.neighbours);
    EXPECT_EQ(result.mesh.positions, mesh.positions);
    EXPECT_EQ(result.mesh.region, mesh.region);
}

TEST(Finish, EveryModeGivesASoundMeshOfTheSameShell) {
    const Shell shells[] = {shapes::icosphere(1, 3),
                            shapes::torus(1, 0.4, 24, 12),
                            shapes::thin_plate(0.02, 6),
                            shapes::subdivided_box(4),
                            shapes::nested_boxes(Role::cavity),
                            shapes::moved(shapes::icosphere(1, 2), {1000, 0, 0}, 1e-3)};
    for (const Shell& shell : shells) {
        const TetMesh mesh = culled(shell);
        for (const Mode mode : {Mode::peel, Mode::full}) {
            Params params;
            params.mode = mode;
            const Result result = finish_mesh(shell, mesh, params);
            expect_sound(shell, result.mesh);
            const NonManifold wrong = non_manifold(boundary_of(result.mesh).faces);
            EXPECT_TRUE(wrong.vertices.empty());
            EXPECT_NEAR(result.report.volume_change, 0, 0.01);
            EXPECT_EQ(result.report.after.tets, result.mesh.tets.size());
        }
    }
}

TEST(Finish, NoMeshGetsWorse) {
    for (const Shell& shell : {shapes::icosphere(1, 3), shapes::torus(1, 0.3, 20, 8), shapes::subdivided_box(3)}) {
        const TetMesh mesh = culled(shell);
        const Result result = finish_mesh(shell, mesh);
        const std::vector<double> before = sorted_shapes(mesh);
        const std::vector<double> after = sorted_shapes(result.mesh);
        EXPECT_GE(after.front(), before.front());
        EXPECT_GE(after[after.size() / 20], before[before.size() / 20]);
        EXPECT_LE(result.report.after.below_10_deg, result.report.before.below_10_deg);
    }
}

TEST(Finish, AFlatBoxKeepsItsVolumeToTheLastDigits) {
    const Shell shell = shapes::subdivided_box(5);
    const Result result = finish_mesh(shell, culled(shell));
    EXPECT_NEAR(result.report.after.volume, 1, 1e-6);
    EXPECT_EQ(result.report.after.below_10_deg, 0u);
}

TEST(Finish, MaterialsKeepTheirVolumes) {
    const Shell shell = shapes::joined(shapes::subdivided_box(6, {0, 0, 0}, {3, 3, 3}),
                                       shapes::subdivided_box(3, {1, 1, 1}, {2, 2, 2}));
    Shell nested = shell;
    nested.components[1].role = Role::rigid;
    nested.components[0].volume = 27;
    nested.components[1].volume = 1;
    const TetMesh mesh = culled(nested);
    std::map<Index, double> before;
    std::map<Index, double> after;
    const auto weigh = [](const TetMesh& m, std::map<Index, double>& volume) {
        for (Index t = 0; t < m.tets.size(); ++t) {
            const auto& [a, b, c, d] = m.tets[t];
            volume[m.region[t]] += signed_volume(m.positions[a], m.positions[b], m.positions[c], m.positions[d]);
        }
    };
    weigh(mesh, before);
    ASSERT_EQ(before.size(), 2u);
    const Result result = finish_mesh(nested, mesh);
    expect_sound(nested, result.mesh);
    weigh(result.mesh, after);
    ASSERT_EQ(after.size(), 2u);
    for (const auto& [region, volume] : before) EXPECT_NEAR(after[region], volume, 1e-6 * volume);
}

TEST(Finish, LocksStayWhereTheyAreAndPaintedEdgesOnTheSurface) {
    Shell shell = shapes::subdivided_box(4);
    for (std::size_t v = 0; v < shell.positions.size(); ++v) shell.locked[v] = shell.positions[v].y == 1;
    const TetMesh mesh = culled(shell);
    const Result result = finish_mesh(shell, mesh);
    expect_sound(shell, result.mesh);
    const auto painted_edges = [&](const TetMesh& m) {
        std::vector<Edge> edges;
        for (const auto& [a, b, c] : boundary_of(m).faces) {
            for (const auto& [from, to] : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) {
                const bool is_painted = from < to && to < shell.locked.size() && shell.locked[from] && shell.locked[to];
                if (is_painted) edges.push_back({from, to});
            }
        }
        std::sort(edges.begin(), edges.end());
        return edges;
    };
    std::vector<Edge> of_shell;
    for (const auto& [a, b, c] : shell.triangles) {
        for (const auto& [from, to] : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) {
            if (from < to && shell.locked[from] && shell.locked[to]) of_shell.push_back({from, to});
        }
    }
    std::sort(of_shell.begin(), of_shell.end());
    const std::vector<Edge> before = painted_edges(mesh);
    const std::vector<Edge> after = painted_edges(result.mesh);
    for (const Edge& edge : before) {
        if (!std::binary_search(of_shell.begin(), of_shell.end(), edge)) continue;
        EXPECT_TRUE(std::binary_search(after.begin(), after.end(), edge)) << edge[0] << ' ' << edge[1];
    }
}

TEST(Finish, ShellVerticesSlideOnlyWhenAskedAndNeverFarNorWhenPaintedNorOffTheirFace) {
    Shell shell = shapes::subdivided_box(5);
    for (std::size_t v = 0; v < shell.positions.size(); ++v) {
        Vec3& p = shell.positions[v];
        // Push the vertices of the faces about, each within its own.
        const double push = 0.08 * (static_cast<double>(v * 7 % 11) / 11 - 0.5);
        if (p.y > 0 && p.y < 1 && p.x > 0 && p.x < 1) p = round_to_float({p.x + push, p.y - push, p.z});
        shell.locked[v] = p.z == 1;
    }
    const TetMesh mesh = culled(shell);
    EXPECT_EQ(finish_mesh(shell, mesh).report.largest_slide, 0);
    Params params;
    params.slide = 0.2;
    const Result result = finish_mesh(shell, mesh, params);
    EXPECT_TRUE(small::is_all_positive(result.mesh));
    EXPECT_GT(result.report.operations.slides, 0u);
    EXPECT_GT(result.report.largest_slide, 0);
    EXPECT_LE(result.report.largest_slide, 0.2 * 0.3);
    for (std::size_t v = 0; v < shell.positions.size(); ++v) {
        const Vec3 before = shell.positions[v];
        const Vec3 after = result.mesh.positions[v];
        if (shell.locked[v]) {
            EXPECT_EQ(before, after);
        }
        for (int axis = 0; axis < 3; ++axis) {
            if (before[axis] == 0 || before[axis] == 1) {
                EXPECT_NEAR(before[axis], after[axis], 1e-6);
            }
        }
    }
    EXPECT_NEAR(result.report.after.volume, 1, 1e-5);
}

TEST(Finish, SameBytesForAnyNumberOfThreads) {
    const Shell shell = shapes::torus(1, 0.4, 24, 12);
    const TetMesh mesh = culled(shell);
    Context many;
    many.jobs = 5;
    const Result one = finish_mesh(shell, mesh);
    const Result other = finish_mesh(shell, mesh, {}, many);
    EXPECT_EQ(one.mesh.tets, other.mesh.tets);
    EXPECT_EQ(one.mesh.positions, other.mesh.positions);
    EXPECT_EQ(one.mesh.neighbours, other.mesh.neighbours);
    EXPECT_EQ(one.report.tried, other.report.tried);
}

TEST(Finish, ScaleDoesNotMatter) {
    const Shell shell = shapes::torus(1, 0.4, 24, 12);
    const TetMesh mesh = culled(shell);
    Shell large = shell;
    TetMesh large_mesh = mesh;
    for (Vec3& p : large.positions) p = p * 4096;
    for (Vec3& p : large_mesh.positions) p = p * 4096;
    const Result one = finish_mesh(shell, mesh);
    const Result other = finish_mesh(large, large_mesh);
    EXPECT_EQ(one.mesh.tets, other.mesh.tets);
    for (std::size_t v = 0; v < one.mesh.positions.size(); ++v)
        EXPECT_EQ(one.mesh.positions[v] * 4096, other.mesh.positions[v]);
}

// Where most tets are bad, planning nodes would spend all of it and nothing be left to mend around them.
TEST(Finish, NodesSpendAQuarterOfTheBudgetAtMost) {
    Shell shell = shapes::torus(1, 0.4, 24, 12);
    for (Vec3& p : shell.positions) p = round_to_float({p.x, p.y, 0.05 * p.z});
    const TetMesh mesh = culled(shell);
    Params params;
    const Operations free = finish_mesh(shell, mesh, params).report.operations;
    ASSERT_GT(free.insertions + free.reseats, 0u);
    params.budget = static_cast<std::uint32_t>(500 / mesh.tets.size()) + 1;  // a quarter of it is less than one plan
    const Operations scarce = finish_mesh(shell, mesh, params).report.operations;
    EXPECT_EQ(scarce.insertions + scarce.reseats, 0u);
    EXPECT_GT(scarce.edge_removals + scarce.face_removals + scarce.moves, 0u);
}

TEST(Finish, ABudgetCountsOperations) {
    const Shell shell = shapes::torus(1, 0.4, 24, 12);
    const TetMesh mesh = culled(shell);
    Params params;
    params.budget = 1;
    const Result result = finish_mesh(shell, mesh, params);
    EXPECT_LE(result.report.tried, mesh.tets.size());
    EXPECT_GT(result.report.tried, 0u);
    EXPECT_TRUE(result.report.is_out_of_budget);
    EXPECT_TRUE(has(result.report, "FINISH_BUDGET"));
    expect_sound(shell, result.mesh);
    params.budget = 0;
    EXPECT_EQ(finish_mesh(shell, mesh, params).report.operations.moves, 0u);
}

TEST(Finish, AThinShellIsNamedAsWhatForcesFlatTets) {
    // Squares of 0.17 on two sides 0.01 apart: atan(t / e) is 3 degrees.
    const Shell shell = plate(6, 0.01);
    const Result result = finish_mesh(shell, culled(shell));
    EXPECT_GT(result.report.forced_thin, 0u);
    EXPECT_EQ(result.report.failed, 0u);
    ASSERT_TRUE(has(result.report, "FINISH_FORCED_THIN"));
    EXPECT_FALSE(has(result.report, "FINISH_BAD_TETS"));
    EXPECT_EQ(result.report.after.below_10_deg, result.report.forced_thin);
}

TEST(Finish, ANeedleOfTheShellIsNamedAsWhatForcesFlatTets) {
    // A vertex on an edge, so near to its end that the triangles there have corners of 0.1 degrees.
    Shell shell = shapes::subdivided_box(2);
    const Triangle first = shell.triangles[0];
    const Vec3 from = shell.positions[first[0]];
    const auto near = static_cast<Index>(shell.positions.size());
    shell.positions.push_back(round_to_float(from + (shell.positions[first[1]] - from) * 0.002));
    for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
        Triangle& at = shell.triangles[t];
        for (int i = 0; i < 3; ++i) {
            if (std::minmax(at[i], at[(i + 1) % 3]) != std::minmax(first[0], first[1])) continue;
            Triangle rest = at;
            rest[i] = near;
            at[(i + 1) % 3] = near;
            shell.triangles.push_back(rest);
            shell.component.push_back(0);
            break;
        }
    }
    shell.locked.push_back(0);
    shell.source_vertex.push_back(near);
    const Result result = finish_mesh(shell, culled(shell));
    EXPECT_GT(result.report.forced_needle, 0u);
    EXPECT_TRUE(has(result.report, "FINISH_FORCED_NEEDLE"));
}

TEST(Finish, TwoSurfacesThatNearlyMeetAreNamedAsWhatForcesFlatTets) {
    const Shell shell =
        shapes::joined(shapes::subdivided_box(3), shapes::subdivided_box(3, {1e-3, 0, 0}, {1.001, 1, 1}));
    const Result result = finish_mesh(shell, culled(shell));
    EXPECT_GT(result.report.forced_gap, 0u);
    EXPECT_TRUE(has(result.report, "FINISH_FORCED_GAP"));
}

TEST(Finish, ARepairIsToldWithWhatWasDone) {
    TetMesh mesh = small::cells(2, [](int x, int y, int z) { return x == y && y == z; });
    mesh.shell_vertex_count = static_cast<Index>(mesh.positions.size());
    const Shell shell = small::shell_of(mesh);
    const Result result = finish_mesh(shell, mesh);
    const auto told = std::find_if(result.report.findings.begin(), result.report.findings.end(),
                                   [](const Finding& finding) { return finding.code == "FINISH_REPAIRED"; });
    ASSERT_NE(told, result.report.findings.end());
    EXPECT_EQ(told->count, 1u);
    EXPECT_EQ(told->severity, Severity::info);
    EXPECT_EQ(result.report.repair.split + result.report.repair.removed, 1u);
    EXPECT_EQ(result.report.repair.nodes_left, 0u);
    EXPECT_TRUE(non_manifold(boundary_of(result.mesh).faces).vertices.empty());
}

TEST(Finish, SpotReachesItsGoal) {
    CRUMPLE_NEEDS_DATA();
    const auto shell = shared_shell("spot");
    ASSERT_TRUE(shell);
    const TetMesh mesh = culled(*shell);
    const Result result = finish_mesh(*shell, mesh);
    expect_sound(*shell, result.mesh);
    EXPECT_EQ(result.report.after.below_10_deg, 0u);
    EXPECT_GE(result.report.after.p5_dihedral_deg, 28);
    EXPECT_NEAR(result.report.after.volume, shell->components[0].volume, 0.003 * shell->components[0].volume);
    EXPECT_FALSE(has(result.report, "FINISH_BAD_TETS"));
}

TEST(Finish, BonnetReachesItsGoal) {
    CRUMPLE_NEEDS_DATA();
    const auto shell = shared_shell("bonnet");
    ASSERT_TRUE(shell);
    const Result result = finish_mesh(*shell, culled(*shell));
    expect_sound(*shell, result.mesh);
    EXPECT_EQ(result.report.after.below_10_deg, 0u);
    EXPECT_GE(result.report.after.min_dihedral_deg, 10.7);
    EXPECT_NEAR(result.report.volume_change, 0, 1e-6);
}

TEST(Finish, DirtyShellsGetAManifoldSurface) {
    CRUMPLE_NEEDS_DATA();
    for (const char* name : {"cow", "suzanne"}) {
        const auto shell = shared_shell(name);
        ASSERT_TRUE(shell);
        const TetMesh mesh = culled(*shell);
        const Result result = finish_mesh(*shell, mesh);
        expect_sound(*shell, result.mesh);
        const NonManifold wrong = non_manifold(boundary_of(result.mesh).faces);
        EXPECT_TRUE(wrong.edges.empty()) << name;
        EXPECT_EQ(wrong.vertices.size(), 0u) << name;
        EXPECT_GE(result.report.after.min_dihedral_deg, 1) << name;
    }
}

}
}
