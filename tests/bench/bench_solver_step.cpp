// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of the bar by ours, the naive and the conventional pipeline, and the loops of ours alone.
#include <algorithm>
#include <cmath>

#include "bench/bench_solver_rows.h"
#include "bench/solver_conventional.h"
#include "bench/solver_naive.h"
#include "bench/stream_read.h"
#include "solver/body.h"
#include "solver/solve.h"

namespace crumple::bench {
namespace {

using solver::test::Body;

solver::Settings budget(int iterations) {
    solver::Settings settings;
    settings.max_iterations = static_cast<std::uint32_t>(iterations);
    settings.plasticity = solver::Plasticity::off;
    return settings;
}

struct StepTimes {
    double ours_s = 0, naive_s = 0, conventional_s = 0;
    double naive_ratio = 0, conventional_ratio = 0;  // theirs / ours
    // Of the velocities, ours against theirs, relative, at the last step that was compared.
    double off_naive = 0, off_conventional = 0;
};

// |ours - theirs| / |ours| over the free nodes; theirs has `stride` numbers a node.
template <class Number>
double difference(const Body& body, std::span<const Number> theirs, std::size_t stride) {
    double off = 0, size = 0;
    for (std::size_t n = 0; n < body.node_count(); ++n) {
        const Vec3f v = velocity(body.state, n);
        for (std::size_t k = 0; k < 3; ++k) {
            const double ours = v[static_cast<int>(k)];
            off += std::pow(ours - static_cast<double>(theirs[stride * n + k]), 2);
            size += ours * ours;
        }
    }
    return std::sqrt(off / size);
}

// Steps 10 to 110 from rest; where the others step too, all three start from the same state.
StepTimes time_steps(const Bundle& bundle, int iterations, bool quick) {
    Body body(bundle, budget(iterations));
    Naive naive(body.bundle, iterations);
    Conventional conventional(body.bundle, iterations);
    const int naive_every = quick ? 25 : 10;
    StepTimes times;
    std::vector<double> ours, naives, conventionals, naive_ratios, conventional_ratios;
    for (int i = 0; i < 110; ++i) {
        const Motion motion{body.state.positions, body.state.velocities};
        const bool is_with_naive = i >= 10 && (i - 10) % naive_every == 0;
        std::span<const double> naive_velocities;
        std::span<const float> conventional_velocities;
        if (is_with_naive) {
            naives.push_back(processor_seconds([&] { naive_velocities = naive.step(motion, bar_dt, bar_gravity); }));
        }
        if (i >= 10) {
            conventionals.push_back(
                processor_seconds([&] { conventional_velocities = conventional.step(motion, bar_dt, bar_gravity); }));
        }
        const double time = processor_seconds([&] { body.step(bar_input()); });
        if (i < 10) continue;
        ours.push_back(time);
        conventional_ratios.push_back(conventionals.back() / time);
        times.off_conventional = difference(body, conventional_velocities, 4);
        if (!is_with_naive) continue;
        naive_ratios.push_back(naives.back() / time);
        times.off_naive = difference(body, naive_velocities, 3);
    }
    times.ours_s = median(ours);
    times.naive_s = median(naives);
    times.conventional_s = median(conventionals);
    times.naive_ratio = median(naive_ratios);
    times.conventional_ratio = median(conventional_ratios);
    return times;
}

double time_stream(std::size_t bytes) {
    const std::vector<float> array(bytes / 4, 1.0f);
    volatile float sink = 0;
    const double best = best_of(50, [&] { sink = sum_of(array); });
    (void)sink;
    return best;
}

// All that an instance needs beside the blob: what its model derives, its state and its workspace, and of the blob what
// a step reads. Shared or not, each is counted once.
double memory_bytes(const solver::Model& m) {
    const double of_blob = static_cast<double>(m.block_count * sizeof(Index) +  // columns
                                               m.node_count * (2 * sizeof(Index) + sizeof(float) + 1 + sizeof(Vec3f)) +
                                               m.edge_count * 3 * sizeof(Index) + m.tet_count * sizeof(Tet));
    return of_blob + static_cast<double>(model_bytes(m.bundle) + state_bytes(m, solver::Plasticity::additive) +
                                         workspace_bytes(m));
}

}

void add_steps(Rows& rows, const Bar& bar, int iterations, bool quick) {
    const StepTimes times = time_steps(bar.bundle, iterations, quick);
    const double thousands = bar.bundle.solver_tet_count / 1e3;
    const std::string name = "step_" + bar.name.substr(bar.name.find('_') + 1);
    const auto per_thousand = [&](double s) { return 1e3 * s / thousands; };
    const std::string unit = "ms per 1k tets";
    rows.push_back(row(name, bar.name, per_thousand(times.ours_s), unit, times.naive_ratio));
    rows.push_back(
        row(name + "_conventional", bar.name, per_thousand(times.conventional_s), unit, times.conventional_ratio));
    rows.push_back(row(name + "_naive", bar.name, per_thousand(times.naive_s), unit));
    rows.push_back(
        row(name + "_conventional_over_naive", bar.name, times.naive_s / times.conventional_s, "times as fast"));
    rows.push_back(row(name + "_off_naive", bar.name, times.off_naive, "of the velocities"));
    rows.push_back(row(name + "_off_conventional", bar.name, times.off_conventional, "of the velocities"));
}

void add_kernels(Rows& rows, const Bar& bar, const std::string& suffix) {
    Body body(bar.bundle, budget(20));
    for (int i = 0; i < 20; ++i) body.step(bar_input());
    const auto& k = solver::kernels(solver::best_isa());
    const solver::Model& m = body.model;
    solver::Workspace& w = body.workspace;
    const solver::EdgeJob edges{m.bundle.edge_start.data(),
                                m.incidence.data(),
                                m.bundle.edge_slots.data()->data(),
                                w.gradients.data(),
                                w.blocks.data(),
                                m.ratio,
                                m.is_uniform};
    const solver::RowJob ends{m.bundle.row_start.data(), m.bundle.diagonal.data(), w.damped_mass.data(),
                              w.blocks.data(), w.inverse.data()};
    // Its memory held other things since.
    std::fill(w.gradients.begin(), w.gradients.end(), 0.5f);
    const double assembly = best_of(50, [&] {
        k.edges(edges, 0, m.edge_count);
        k.rows(ends, 0, m.node_count);
    });
    rows.push_back(row(suffix == "_5k" ? "assembly_ns_per_tet" : "assembly_ns_per_tet" + suffix, bar.name,
                       1e9 * assembly / static_cast<double>(m.tet_count), "ns"));
    const solver::SolveJob solve = solve_job(m, w);
    const double multiply = best_of(100, [&] { k.multiply(solve, 0, m.node_count); });
    rows.push_back(
        row("spmv_ns_per_block" + suffix, bar.name, 1e9 * multiply / static_cast<double>(m.block_count), "ns"));
    rows.push_back(
        row("spmv_fraction" + suffix, bar.name, time_stream(40 * m.block_count) / multiply, "of stream read"));
}

void add_memory(Rows& rows, const Bar& bar) {
    const Body body(bar.bundle);
    rows.push_back(row("memory_bytes_per_tet", bar.name,
                       memory_bytes(body.model) / static_cast<double>(body.model.tet_count), "bytes"));
}

}
