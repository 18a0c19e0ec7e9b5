// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/solver_bar.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

#include "bake/bake.h"
#include "bench/tetgen_files.h"
#include "mesh/boundary.h"
#include "mesh/neighbours.h"
#include "solver/body.h"

namespace crumple::bench {
namespace {

// The count of tets depends on this order of the nodes.
constexpr char bar_poly[] =
    "8 3 0 0\n1 0 0 0\n2 8 0 0\n3 8 1 0\n4 0 1 0\n5 0 0 1\n6 8 0 1\n7 8 1 1\n8 0 1 1\n"
    "6 0\n1\n4 1 2 3 4\n1\n4 5 6 7 8\n1\n4 1 2 6 5\n1\n4 2 3 7 6\n1\n4 3 4 8 7\n1\n4 4 1 5 8\n0\n0\n";

bool is_positive(const TetMesh& mesh, const Tet& tet) {
    const auto edge = [&](std::size_t i) { return mesh.positions[tet[i]] - mesh.positions[tet[0]]; };
    return dot(edge(1), cross(edge(2), edge(3))) > 0;
}

// Places that float can hold, and every tet positive.
void make_usable(TetMesh& mesh) {
    for (Vec3& p : mesh.positions) p = round_to_float(p);
    for (Tet& tet : mesh.tets) {
        if (!is_positive(mesh, tet)) std::swap(tet[2], tet[3]);
    }
}

std::optional<TetMesh> run_tetgen(const std::string& switches) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "crumple_bench_bar";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "bar.poly") << bar_poly;
    const std::string command = "cd '" + folder.string() + "' && tetgen -" + switches + " bar.poly >/dev/null 2>&1";
    const bool is_run = std::system(command.c_str()) == 0;
    TetMesh mesh = is_run ? read_tetgen(folder, "bar", 1) : TetMesh{};
    make_usable(mesh);
    std::filesystem::remove_all(folder);
    if (mesh.tets.empty()) return std::nullopt;
    return mesh;
}

// As any other mesh is baked, so that nodes and tets are in the order a game gets them in.
Bundle bake(TetMesh mesh) {
    mesh.shell_vertex_count = static_cast<Index>(mesh.positions.size());
    mesh.neighbours = neighbours_of(mesh.tets);
    Asset asset;
    Shell& shell = asset.shell;
    shell.positions = mesh.positions;
    shell.triangles = boundary_of(mesh).faces;
    shell.component.assign(shell.triangles.size(), 0);
    shell.components.push_back({"bar", "", Role::solid, "", 8, true, false, none});
    for (const Vec3 p : shell.positions) {
        shell.locked.push_back(p.x == 0);
        if (p.x == 0) asset.locked_positions.push_back(p);
    }
    std::sort(asset.locked_positions.begin(), asset.locked_positions.end(), lexicographic_less<double>);
    bake::Params params;
    params.materials = {bar_material()};
    params.material_by_role = {{"solid", params.materials[0].name}};
    return bake_bundle(asset, mesh, {}, params).bundle;
}

Bundle grid_bar(int cells) {
    const float size = 8.0f / static_cast<float>(cells);
    const int across = static_cast<int>(std::lround(1 / size));
    const float side = 1.0f / static_cast<float>(across);
    return solver::test::grid_body({cells, across, across}, {size, side, side}, bar_material(),
                                   [](Vec3f p) { return p.x == 0; });
}

}

Material bar_material() {
    Material m = solver::test::elastic_material(1e6, 0.3);
    m.alpha_per_s = 0.15;
    m.beta_s = 0.004;
    return m;
}

solver::StepInput bar_input() {
    solver::StepInput input;
    input.dt = bar_dt;
    input.gravity = {0, bar_gravity, 0};
    return input;
}

Bar make_bar(BarSize size) {
    const bool is_small = size == BarSize::small;
    const std::string tets = is_small ? "5k" : "50k";
    if (auto mesh = run_tetgen(is_small ? "pq1.3a0.0042" : "pq1.3a0.00035")) {
        return {bake(std::move(*mesh)), "bar_" + tets, true};
    }
    return {grid_bar(is_small ? 36 : 80), "grid_" + tets, false};
}

}
