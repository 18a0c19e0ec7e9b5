// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of bench_solver, a file a kind.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "bench/solver_bar.h"

namespace crumple::bench {

using Rows = std::vector<Row>;

inline Row row(const std::string& name, const std::string& input, double value, const std::string& unit,
               std::optional<double> ratio = std::nullopt) {
    return {name, input, {{"value", value}, {"unit", unit}, {"ratio", ratio}}};
}

// REQUIRES: not empty.
inline double percentile(std::vector<double> values, std::size_t percent) {
    std::sort(values.begin(), values.end());
    return values[(values.size() - 1) * percent / 100];
}

// One thread's work takes this on a machine that does nothing else.
template <class Work>
double processor_seconds(Work&& work, double (*clock)() = cpu_seconds) {
    const double begin = clock();
    work();
    return clock() - begin;
}

template <class Work>
double best_of(int rounds, Work&& work) {
    double best = 1e30;
    for (int i = 0; i < rounds; ++i) best = std::min(best, processor_seconds(work));
    return best;
}

// The columns of the tables of [Civit-Flores, Susin 2014], and one of ours.
struct Way {
    const char* name;
    solver::RotationMethod rotation;
    solver::Treatment treatment;
};
inline constexpr Way ways[] = {{"qr", solver::RotationMethod::qr, solver::Treatment::off},
                               {"svd1", solver::RotationMethod::svd_smallest, solver::Treatment::off},
                               {"svd2", solver::RotationMethod::svd_last, solver::Treatment::off},
                               {"project", solver::RotationMethod::apd, solver::Treatment::project},
                               {"reflect", solver::RotationMethod::apd, solver::Treatment::reflect},
                               {"smooth", solver::RotationMethod::apd, solver::Treatment::smooth}};

// bench_solver_step.cpp
void add_steps(Rows& rows, const Bar& bar, int iterations, bool quick);
void add_kernels(Rows& rows, const Bar& bar, const std::string& suffix);
void add_memory(Rows& rows, const Bar& bar);
// bench_solver_rotation.cpp
void add_rotations(Rows& rows, const std::string& name, solver::Isa isa);
void add_half_inverted(Rows& rows);
void add_rotation_table(Rows& rows);
// bench_solver_truth.cpp
void add_scramble(Rows& rows, int seeds);
void add_recovery_table(Rows& rows, int seeds);
void add_tip_error(Rows& rows, const Bar& bar);
// bench_solver_game.cpp
void add_asleep(Rows& rows);
void add_skin(Rows& rows);
void add_load(Rows& rows, const Bar& bar);
void add_two_threads(Rows& rows, const Bar& bar, std::uint32_t iterations);
// bench_solver_cars.cpp
void add_cars(Rows& rows, bool quick);
// bench_solver_crash.cpp
void add_crash(Rows& rows, const std::string& finish_mode);

}
