// SPDX-License-Identifier: GPL-3.0-or-later
// What every benchmark program shares: `bench_NAME [--quick] --json FILE` measures, prints a table and writes
// {machine, date, rows: [{name, input, ...figures}]}. A figure without a value (a missing peer) is null.
#pragma once
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace crumple::bench {

// One measured line: what ran, on which input (kind_size: uniform_10k, grid_20, car_2k), and its figures in order.
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

// The body of main: reads the command line, calls `measure(quick)`, prints and writes. Returns the exit code.
int run(int argc, char** argv, std::vector<Row> (*measure)(bool quick));

}
