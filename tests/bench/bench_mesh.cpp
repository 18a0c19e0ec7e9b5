// SPDX-License-Identifier: GPL-3.0-or-later
// The whole way from a shell to tets against other mesh generators: how many tets, how good, how near to the shell, at
// what price. One row a shell and tool:
//   crumple            default settings
//   crumple_matched    as many interior points, and where none are too many as dear nodes of finish, as bring the tets
//                      within a tenth of HXT's (TetGen's where HXT fails); nulls where none do
//   crumple_peel       as crumple, finish.mode peel
//   crumple_none       as crumple, finish.mode none
//   tetgen, hxt, gmsh  as packaged by Debian
//   crumple_50k        as crumple with 50,000 tets asked for; not with --quick
// Every figure is measured here, on the mesh, in the same way for all tools. A tool that fails is a row of nulls.
#include <cmath>
#include <filesystem>
#include <iostream>

#include "bench/bench.h"
#include "bench/mesh_case.h"
#include "bench/mesh_peers.h"
#include "finish/finish.h"

namespace crumple {
namespace {

using bench::Made;
using bench::MeshCase;

const std::vector<std::string> all_shells{"bonnet", "boxnest", "carbody", "carhood",
                                          "cow",    "fandisk", "spot",    "suzanne"};
const std::vector<std::string> quick_shells{"spot", "carbody", "bonnet"};

constexpr int most_rounds = 6;
constexpr double near_enough = 0.03;   // of the tets wanted: no need to try on
constexpr double still_matched = 0.1;  // of the tets wanted

double tets_off(const Made& made, double wanted) { return static_cast<double>(made.mesh.tets.size()) - wanted; }

// Tets grow about as fast as points, so a secant finds their number; of all meshes on the way the nearest is taken.
std::optional<Made> search(const MeshCase& of, const std::vector<std::string>& settings, double wanted) {
    const auto cook = [&](const std::string& count) {
        std::vector<std::string> all = settings;
        all.push_back("sample.points=" + count);
        return of.cook(all);
    };
    const auto points = [](const Made& m) { return static_cast<double>(m.interior_points); };
    const auto is_nearer = [&](const Made& a, const Made& b) {
        return std::fabs(tets_off(a, wanted)) < std::fabs(tets_off(b, wanted));
    };
    std::optional<Made> fewest = cook("0");
    std::optional<Made> automatic = cook("auto");
    if (!fewest || !automatic) return std::nullopt;
    Made a = std::move(*fewest);
    Made b = std::move(*automatic);
    Made best = is_nearer(a, b) ? a : b;
    for (int round = 0; round < most_rounds && std::fabs(tets_off(best, wanted)) > near_enough * wanted; ++round) {
        const double slope = (tets_off(b, wanted) - tets_off(a, wanted)) / (points(b) - points(a));
        if (!(slope > 0)) break;
        const double guess = points(b) - tets_off(b, wanted) / slope;
        if (!(guess >= 1) || guess > 1e6) break;
        std::optional<Made> next = cook(std::to_string(std::lround(guess)));
        if (!next || next->interior_points == b.interior_points) break;
        a = std::move(b);
        b = std::move(*next);
        if (is_nearer(b, best)) best = b;
    }
    return best;
}

// Where even no point gives too many, because finish adds nodes of its own, a few points spare it some; where that is
// not enough its nodes get dearer, by a fifth each time.
constexpr double few_points[] = {0, 0.03, 0.06, 0.12};  // of the automatic number
constexpr double dearest = 20;                          // for nodes: no more are added

std::optional<Made> matched(const MeshCase& of, double wanted) {
    std::optional<Made> best = search(of, {}, wanted);
    if (!best) return std::nullopt;
    const auto is_matched = [&] { return std::fabs(tets_off(*best, wanted)) <= still_matched * wanted; };
    const std::optional<Made> automatic = of.cook({});
    if (!automatic) return std::nullopt;
    for (double price = finish::Params().node_price; !is_matched() && price < dearest; price *= 1.2) {
        for (const double share : few_points) {
            const double count = share * static_cast<double>(automatic->interior_points);
            std::optional<Made> next = of.cook(
                {"finish.node_price=" + std::to_string(price), "sample.points=" + std::to_string(std::lround(count))});
            if (next && std::fabs(tets_off(*next, wanted)) < std::fabs(tets_off(*best, wanted))) best = std::move(next);
        }
    }
    if (is_matched()) return best;
    std::cerr << of.name() << ": " << best->mesh.tets.size() << " tets is as near as it gets to the " << wanted
              << " of crumple_matched\n";
    return std::nullopt;
}

std::optional<Made> run_peer(const MeshCase& of, const std::string& tool) {
    const auto folder = std::filesystem::temp_directory_path() / "crumple_bench_mesh" / of.name() / tool;
    auto peer = bench::run_peer(tool, bench::read_raw_shell(of.path()), folder);
    std::filesystem::remove_all(folder);
    if (!peer) return std::nullopt;
    return Made{std::move(peer->mesh), peer->cpu_s};
}

bench::Row row(const MeshCase& of, const std::string& tool, const std::optional<Made>& made) {
    bench::Row row{{}, {}, {{"shell", of.name()}, {"tool", tool}}};
    for (auto& figure : of.figures(made)) row.figures.push_back(std::move(figure));
    return row;
}

std::vector<bench::Row> measure(const std::string& shell) {
    const MeshCase of(shell);
    std::vector<bench::Row> rows;
    const auto add = [&](const std::string& tool, const std::optional<Made>& made) {
        rows.push_back(row(of, tool, made));
    };
    const std::optional<Made> ours = of.cook({});
    const std::optional<Made> tetgen = run_peer(of, "tetgen");
    const std::optional<Made> hxt = run_peer(of, "hxt");
    const std::optional<Made>& like = hxt ? hxt : tetgen;
    add("crumple", ours);
    if (ours && like) add("crumple_matched", matched(of, static_cast<double>(like->mesh.tets.size())));
    add("crumple_peel", of.cook({"finish.mode=peel"}));
    add("crumple_none", of.cook({"finish.mode=none"}));
    add("tetgen", tetgen);
    add("hxt", hxt);
    add("gmsh", run_peer(of, "gmsh"));
    return rows;
}

std::vector<bench::Row> measure_large(const std::string& shell, const std::string& folder) {
    const MeshCase of(shell, folder);
    return {row(of, "crumple_50k", of.cook({"sample.points=tets:50000"}))};
}

void add_all(bool quick) {
    for (const std::string& shell : quick ? quick_shells : all_shells) {
        bench::add_once("mesh/" + shell, [shell] { return measure(shell); });
    }
    if (quick) return;
    bench::add_once("mesh_50k/spot", [] { return measure_large("spot", "quality"); });
}

}
}

int main(int argc, char** argv) { return crumple::bench::run_on_shells(argc, argv, crumple::add_all); }
