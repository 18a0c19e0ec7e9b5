// SPDX-License-Identifier: GPL-3.0-or-later
// What quality costs in fidelity: the same shell finished not at all, peeled, and in full with the surface allowed to
// stray further and further from the shell. One row a shell and setting; scripts/chart_curve.py draws them.
#include <cstdio>

#include "bench/bench.h"
#include "bench/mesh_case.h"

namespace crumple {
namespace {

struct Setting {
    std::string name;
    double gap = 0;  // how far the surface may stray, share of the diagonal
    std::vector<std::string> settings;
};

// Folds and the local bound are let go, so that the distance alone bounds what the surface does.
std::vector<Setting> all_settings() {
    std::vector<Setting> settings{{"none", 0, {"finish.mode=none"}}, {"peel", 0, {"finish.mode=peel"}}};
    for (const double gap : {0.0, 0.0005, 0.001, 0.002, 0.005, 0.01}) {
        char number[32];
        std::snprintf(number, sizeof number, "%g", gap);
        settings.push_back({"full",
                            gap,
                            {"finish.mode=full", "finish.fold_deg=30", "finish.surface_gap=0.2",
                             std::string("finish.surface_gap_diagonal=") + number}});
    }
    settings.push_back({"default", 0.001, {}});
    return settings;
}

std::vector<bench::Row> measure(const std::string& shell) {
    const bench::MeshCase of(shell);
    std::vector<bench::Row> rows;
    for (const Setting& setting : all_settings()) {
        rows.push_back({{}, {}, {{"shell", shell}, {"finish", setting.name}, {"surface_gap_diagonal", setting.gap}}});
        for (auto& figure : of.figures(of.cook(setting.settings))) rows.back().figures.push_back(std::move(figure));
    }
    return rows;
}

void add_all(bool quick) {
    for (const std::string shell : {"spot", "fandisk", "carbody"}) {
        if (quick && shell != "spot") continue;
        bench::add_once("curve/" + shell, [shell] { return measure(shell); });
    }
}

}
}

int main(int argc, char** argv) { return crumple::bench::run_on_shells(argc, argv, crumple::add_all); }
