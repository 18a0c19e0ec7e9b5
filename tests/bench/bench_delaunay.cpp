// SPDX-License-Identifier: GPL-3.0-or-later
// delaunay against CGAL on the same points in the same run: median over pairs in alternating order, CPU time of one
// thread, coordinates in memory before, tets with neighbours in memory after. CRUMPLE_BENCH_ONLY=sphere runs only the
// inputs whose names hold that text.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
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
    std::string name;
    std::function<workloads::Points()> make;
    bool is_quick;
};

const std::vector<Input>& inputs() {
    static const std::vector<Input> list{
        {"uniform_1k", [] { return workloads::uniform(1000); }, true},
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

Pairs measure_pairs(const PointSet& points, bench::CgalPeer& peer, delaunay::Order order, double budget_s) {
    constexpr std::size_t fewest = 5;
    constexpr std::size_t most = 201;
    Pairs pairs;
    std::vector<double> ours, cgal, ratio;
    double spent = 0;
    for (std::size_t i = 0; i < most && (i < fewest || spent < budget_s || i % 2 == 0); ++i) {
        if (i % 2 == 0) cgal.push_back(peer.run());
        ours.push_back(run_ours(points, order, pairs.tets));
        if (i % 2 == 1) cgal.push_back(peer.run());
        ratio.push_back(ours[i] / cgal[i]);
        spent += ours[i] + cgal[i];
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

bench::Row measure(const std::string& input, const PointSet& points, bench::CgalPeer& peer, delaunay::Order order,
                   double cgal_bytes, double budget_s) {
    const auto count = static_cast<double>(points.positions.size());
    const Pairs pairs = measure_pairs(points, peer, order, budget_s);
    std::size_t tets = 0;
    const double bytes = peak_bytes([&] { run_ours(points, order, tets); });
    std::fprintf(stderr, "%-22s %-9s %8.0f ns/point  CGAL %8.0f  ratio %.3f  %4.0f bytes/point  CGAL %4.0f\n",
                 input.c_str(), std::string(name_of(order)).c_str(), 1e9 * pairs.ours / count, 1e9 * pairs.cgal / count,
                 pairs.ratio, bytes / count, cgal_bytes / count);
    return {"delaunay",
            input,
            {{"order", std::string(name_of(order))},
             {"points", count},
             {"tets", static_cast<double>(pairs.tets)},
             {"ns_per_point", 1e9 * pairs.ours / count},
             {"cgal_ns_per_point", 1e9 * pairs.cgal / count},
             {"ratio_cgal", pairs.ratio},
             {"bytes_per_point", bytes / count},
             {"cgal_bytes_per_point", cgal_bytes / count}}};
}

std::vector<bench::Row> measure_input(const Input& input, bool quick) {
    PointSet points;
    points.positions = input.make();
    bench::CgalPeer peer(points.positions);
    peer.run();
    // A second one, freed again: the peak above what is in use then is one triangulation.
    const double cgal_bytes = [&] {
        bench::CgalPeer fresh(points.positions);
        return peak_bytes([&] { fresh.run(); });
    }();
    std::vector<bench::Row> rows;
    for (const auto& order : delaunay::order_names) {
        const bool is_main = order.value == delaunay::Order::automatic || order.value == delaunay::Order::quickhull;
        if (quick && !is_main) continue;
        rows.push_back(measure(input.name, points, peer, order.value, cgal_bytes, quick ? 0.4 : 3.0));
    }
    return rows;
}

std::vector<bench::Row> measure_all(bool quick) {
    const char* only = std::getenv("CRUMPLE_BENCH_ONLY");
    std::vector<bench::Row> rows;
    for (const Input& input : inputs()) {
        if (quick && !input.is_quick) continue;
        if (only != nullptr && input.name.find(only) == std::string::npos) continue;
        for (bench::Row& row : measure_input(input, quick)) rows.push_back(std::move(row));
    }
    return rows;
}

}
}

int main(int argc, char** argv) { return crumple::bench::run(argc, argv, crumple::measure_all); }
