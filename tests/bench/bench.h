// SPDX-License-Identifier: GPL-3.0-or-later
// What every benchmark program shares, around Google Benchmark: `bench_NAME [--quick] [--json FILE]
// [--benchmark_filter=..]` measures, prints a table and writes {machine, date, rows: [{name, input, ...figures}]}. A
// figure without a value (a missing peer) is null.
#pragma once
#include <benchmark/benchmark.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace crumple::bench {

// One measured line: what ran, on which input (kind_size: uniform_10k, grid_20, car_2k), and its figures in order. Name
// and input may be empty: then the figures say it.
struct Row {
    using Value = std::variant<std::optional<double>, std::string>;
    std::string name;
    std::string input;
    std::vector<std::pair<std::string, Value>> figures;
};

// Seconds that one call of `work` takes on the wall clock.
template <class Work>
double seconds(Work&& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// The middle of an odd number of values, the mean of the middle two of an even number. REQUIRES: not empty.
[[nodiscard]] double median(std::vector<double> values);

// Alternates `ours` and `peer` so that both meet the same weather, and returns the median seconds of each.
struct Paired {
    double ours = 0;
    double peer = 0;
    double ratio = 0;  // median of ours / peer of each round
};
template <class Ours, class Peer>
Paired paired(int rounds, Ours&& ours, Peer&& peer) {
    std::vector<double> our_times, peer_times, ratios;
    for (int round = 0; round < rounds; ++round) {
        our_times.push_back(seconds(ours));
        peer_times.push_back(seconds(peer));
        ratios.push_back(our_times.back() / peer_times.back());
    }
    return {median(our_times), median(peer_times), median(ratios)};
}

// Registers a benchmark on manual time. `measure` loops over the state (each pass one run of ours, and of the peer
// where there is one), gives it the seconds of ours, and returns the rows of what it saw; of its calls the last one's
// count.
using Measure = std::function<std::vector<Row>(benchmark::State& state)>;
benchmark::internal::Benchmark* add(const std::string& name, Measure measure);

// The same for work that repeats and takes medians by itself.
void add_once(const std::string& name, std::function<std::vector<Row>()> measure);

// The body of main: reads the command line, lets `add_all(quick)` register, runs, prints and writes. Returns the exit
// code.
int run(int argc, char** argv, void (*add_all)(bool quick));

}
