// SPDX-License-Identifier: GPL-3.0-or-later
// delaunay against CGAL on the same points in the same run: median over pairs in alternating order, CPU time of one
// thread, coordinates in memory before, tets with neighbours in memory after.
#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/cgal_peer.h"
#include "bench/cpu_time.h"
#include "bench/heap_count.h"
#include "delaunay/delaunay.h"
#include "delaunay/workloads.h"

namespace crumple {
namespace {

struct Input {
    std::string name;  // trap_*: has no target
    std::function<workloads::Points()> make;
    bool is_quick;
};

const std::vector<Input>& inputs() {
    static const std::vector<Input> list{
        {"uniform_10k", [] { return workloads::uniform(10000); }, true},
        {"uniform_100k", [] { return workloads::uniform(100000); }, true},
        {"uniform_1m", [] { return workloads::uniform(1000000); }, false},
        {"clusters_20k", [] { return workloads::clusters(20000); }, true},
        {"clusters_100k", [] { return workloads::clusters(100000); }, false},
        {"grid_10", [] { return workloads::grid(10); }, true},
        {"grid_20", [] { return workloads::grid(20); }, true},
        {"grid_47", [] { return workloads::grid(47); }, false},
        {"sphere_10k", [] { return workloads::sphere(10000); }, true},
        {"sphere_100k", [] { return workloads::sphere(100000); }, false},
        {"car_2k", [] { return workloads::car(2000); }, true},
        {"car_20k", [] { return workloads::car(20000); }, true},
        {"trap_uniform_1k", [] { return workloads::uniform(1000); }, true},
        {"trap_cospherical_1105", [] { return workloads::integer_sphere(1105); }, true},
        {"trap_lines_400", [] { return workloads::lines(400); }, true},
        {"trap_slab_2k", [] { return workloads::thin_slab(2000); }, true},
        {"trap_duplicated_20k", [] { return workloads::half_duplicated(20000); }, true},
        {"trap_offset_5k",
         [] {
             return workloads::scaled(workloads::uniform(5000), {1e6, 1e6, 1e6}, {1e15, 1e15, 1e15});
         },
         true},
    };
    return list;
}

struct Pairs {
    double ours = 0;
    double cgal = 0;
    double ratio = 0;
    std::size_t tets = 0;
};

double run_ours(const PointSet& points, delaunay::Order order, std::size_t& tets) {
    const double start = bench::cpu_seconds();
    const auto result = delaunay::tetrahedralize(points, {order});
    const double seconds = bench::cpu_seconds() - start;
    tets = result.mesh.tets.size();
    return seconds;
}

Pairs measure_pairs(benchmark::State& state, const PointSet& points, bench::CgalPeer& peer, delaunay::Order order) {
    Pairs pairs;
    std::vector<double> ours, cgal, ratio;
    for (bool is_cgal_first = true; state.KeepRunning(); is_cgal_first = !is_cgal_first) {
        if (is_cgal_first) cgal.push_back(peer.run());
        ours.push_back(run_ours(points, order, pairs.tets));
        if (!is_cgal_first) cgal.push_back(peer.run());
        ratio.push_back(ours.back() / cgal.back());
        state.SetIterationTime(ours.back());
    }
    pairs.ours = bench::median(ours);
    pairs.cgal = bench::median(cgal);
    pairs.ratio = bench::median(ratio);
    return pairs;
}

double peak_bytes(const std::function<void()>& work) {
    bench::reset_heap_peak();
    const auto before = static_cast<double>(bench::heap_in_use());
    work();
    return static_cast<double>(bench::heap_peak()) - before;
}

// Points and peer of one input, made when its first benchmark runs and shared by those of the other orders.
struct Scene {
    explicit Scene(const Input& input) : points{input.make(), 0}, peer(points.positions) {
        peer.run();
        // A second one, freed again: the peak above what is in use then is one triangulation.
        bench::CgalPeer fresh(points.positions);
        cgal_bytes = peak_bytes([&] { fresh.run(); });
    }
    PointSet points;
    bench::CgalPeer peer;
    double cgal_bytes = 0;
};

bench::Row measure(benchmark::State& state, const std::string& input, Scene& scene, delaunay::Order order) {
    const auto count = static_cast<double>(scene.points.positions.size());
    const Pairs pairs = measure_pairs(state, scene.points, scene.peer, order);
    std::size_t tets = 0;
    const double bytes = peak_bytes([&] { run_ours(scene.points, order, tets); });
    return {"delaunay",
            input,
            {{"order", std::string(name_of(order))},
             {"points", count},
             {"tets", static_cast<double>(pairs.tets)},
             {"ns_per_point", 1e9 * pairs.ours / count},
             {"cgal_ns_per_point", 1e9 * pairs.cgal / count},
             {"ratio_cgal", pairs.ratio},
             {"bytes_per_point", bytes / count},
             {"cgal_bytes_per_point", scene.cgal_bytes / count}}};
}

void add_input(const Input& input, bool quick) {
    const auto scene = std::make_shared<std::unique_ptr<Scene>>();
    for (const auto& order : delaunay::order_names) {
        const bool is_main = order.value == delaunay::Order::automatic || order.value == delaunay::Order::quickhull;
        if (quick && !is_main) continue;
        const auto measure_order = [scene, input, value = order.value](benchmark::State& state) {
            if (!*scene) *scene = std::make_unique<Scene>(input);
            return std::vector<bench::Row>{measure(state, input.name, **scene, value)};
        };
        bench::add("delaunay/" + input.name + "/" + std::string(order.name), measure_order)
            ->MinTime(quick ? 0.15 : 1.5);
    }
}

void add_all(bool quick) {
    for (const Input& input : inputs()) {
        if (input.is_quick || !quick) add_input(input, quick);
    }
}

}
}

int main(int argc, char** argv) { return crumple::bench::run(argc, argv, crumple::add_all); }
