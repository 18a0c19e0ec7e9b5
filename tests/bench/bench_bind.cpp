// SPDX-License-Identifier: GPL-3.0-or-later
// bind on one thread: up to a million visual vertices against 48 000 tets, in random order.
// CPU time, building the trees included; seconds is the median of the rounds.
#include <cmath>

#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "bind/bind.h"
#include "core/random.h"
#include "mesh/shapes.h"

namespace crumple {
namespace {

struct Scene {
    Shell shell;
    TetMesh mesh;
};

// A unit cube of cells^3 * 6 tets in one region.
Scene cube_scene(int cells) {
    Scene scene{shapes::subdivided_box(cells), shapes::tet_grid(cells)};
    scene.mesh.region.assign(scene.mesh.tets.size(), 0);
    return scene;
}

// A share of the vertices within the cube, the others up to 2 % outside its surface, in random order.
VisualMesh around_cube(std::size_t count, double inside_share) {
    VisualMesh visual;
    visual.name = "visual";
    Rng rng(7);
    const auto inside = static_cast<std::size_t>(inside_share * static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const double u = rng.next_unit();
        const double v = rng.next_unit();
        const double w = rng.next_unit();
        Vec3 p{u, v, w};
        if (i >= inside) {
            const std::uint32_t side = rng.next_below(6);
            p[side / 2] = side % 2 ? 1 + 0.02 * w : -0.02 * w;
        }
        visual.positions.push_back(round_to_float(p));
    }
    for (std::size_t i = count; i > 1; --i) {
        std::swap(visual.positions[i - 1], visual.positions[rng.next_below(static_cast<std::uint32_t>(i))]);
    }
    return visual;
}

bench::Row measure_bind(benchmark::State& state, const std::string& input, const Scene& scene,
                        const VisualMesh& visual) {
    std::vector<double> times;
    bind::Report report;
    while (state.KeepRunning()) {
        const double begin = bench::cpu_seconds();
        report = bind::bind_visuals(scene.shell, scene.mesh, std::span(&visual, 1)).report;
        times.push_back(bench::cpu_seconds() - begin);
        state.SetIterationTime(times.back());
    }
    const double seconds = bench::median(times);
    const auto vertices = static_cast<double>(visual.positions.size());
    return {"bind",
            input,
            {{"vertices", vertices},
             {"tets", static_cast<double>(scene.mesh.tets.size())},
             {"outside", static_cast<double>(report.outside)},
             {"seconds", seconds},
             {"ns_per_vertex", seconds / vertices * 1e9}}};
}

struct Case {
    std::string input;
    int cells;
    std::size_t vertices;
    double inside_share;
    bool is_quick;
};

const Case cases[] = {
    {"half_outside_50k", 10, 50000, 0.5, true},   // 6 000 tets
    {"half_outside_1m", 20, 1000000, 0.5, true},  // 48 000 tets
    {"inside_1m", 20, 1000000, 1, false},
    {"outside_1m", 20, 1000000, 0, false},
};

void add_all(bool quick) {
    for (const Case& c : cases) {
        if (quick && !c.is_quick) continue;
        const auto measure = [c](benchmark::State& state) {
            const Scene scene = cube_scene(c.cells);
            const VisualMesh visual = around_cube(c.vertices, c.inside_share);
            return std::vector<bench::Row>{measure_bind(state, c.input, scene, visual)};
        };
        bench::add("bind/" + c.input, measure)->Iterations(quick ? 3 : 7);
    }
}

}
}

int main(int argc, char** argv) { return crumple::bench::run(argc, argv, crumple::add_all); }
