// SPDX-License-Identifier: GPL-3.0-or-later
// sample on one thread: 1 000 to 200 000 points within a torus, evenly spread and independent.
// CPU time; seconds is the median of the rounds.
#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "mesh/shapes.h"
#include "sample/sample.h"

namespace crumple {
namespace {

struct Case {
    std::string input;
    sample::Method method;
    const char* points;
    bool is_quick;
};

const Case cases[] = {
    {"poisson_1k", sample::Method::poisson, "1000", true},   {"poisson_10k", sample::Method::poisson, "10000", true},
    {"poisson_50k", sample::Method::poisson, "50000", true}, {"poisson_200k", sample::Method::poisson, "200000", false},
    {"uniform_50k", sample::Method::uniform, "50000", true},
};

bench::Row measure_sample(benchmark::State& state, const Case& c, const Shell& shell) {
    sample::Params params;
    params.method = c.method;
    params.points = c.points;
    std::vector<double> times;
    sample::Report report;
    while (state.KeepRunning()) {
        const double begin = bench::cpu_seconds();
        report = sample::sample_interior(shell, params).report;
        times.push_back(bench::cpu_seconds() - begin);
        state.SetIterationTime(times.back());
    }
    const double seconds = bench::median(times);
    const auto points = static_cast<double>(report.points);
    return {"sample",
            c.input,
            {{"shell_triangles", static_cast<double>(shell.triangles.size())},
             {"points", points},
             {"spacing", report.spacing},
             {"seconds", seconds},
             {"us_per_point", seconds / points * 1e6}}};
}

void add_all(bool quick) {
    for (const Case& c : cases) {
        if (quick && !c.is_quick) continue;
        const auto measure = [c](benchmark::State& state) {
            const Shell shell = shapes::torus(1, 0.4, 48, 24);
            return std::vector<bench::Row>{measure_sample(state, c, shell)};
        };
        bench::add("sample/" + c.input, measure)->Iterations(quick ? 3 : 7);
    }
}

}
}

int main(int argc, char** argv) { return crumple::bench::run(argc, argv, crumple::add_all); }
