// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of the bar by ours, the naive and the conventional pipeline, and the loops of ours alone.
#include <algorithm>
#include <cmath>

#include "bench/bench_solver_rows.h"
#include "bench/solver_conventional.h"
#include "bench/solver_naive.h"
#include "bench/stream_read.h"
#include "bundle/blob.h"
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

// |ours - theirs| / |ours|; theirs has `stride` numbers a node.
template <class Number>
double difference(std::span<const float> ours, std::span<const Number> theirs, std::size_t stride) {
    double off = 0, size = 0;
    for (std::size_t n = 0; stride * n < theirs.size(); ++n) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double v = ours[4 * n + k];
            off += std::pow(v - static_cast<double>(theirs[stride * n + k]), 2);
            size += v * v;
        }
    }
    return std::sqrt(off / size);
}

constexpr std::size_t steps_from = 10, steps_to = 110;

// The states ours went through, and what came of each.
struct Course {
    std::vector<std::vector<float>> positions, velocities, after;
    std::vector<double> seconds;
};

Course run_ours(const Bundle& bundle, int iterations) {
    Body body(bundle, budget(iterations));
    Course course;
    const auto copy = [](std::span<const float> rows) { return std::vector<float>(rows.begin(), rows.end()); };
    for (std::size_t i = 0; i < steps_to; ++i) {
        if (i < steps_from) {
            body.step(bar_input());
            continue;
        }
        course.positions.push_back(copy(body.state.positions));
        course.velocities.push_back(copy(body.state.velocities));
        course.seconds.push_back(processor_seconds([&] { body.step(bar_input()); }));
        course.after.push_back(copy(body.state.velocities));
    }
    return course;
}

// Another pipeline's median seconds over every so many of the same states; `off` becomes how far the last one's
// velocities are from ours.
template <class Pipeline>
double run_theirs(Pipeline& pipeline, const Course& course, std::size_t every, std::size_t stride, double& off) {
    std::vector<double> times;
    for (std::size_t i = 0; i < course.positions.size(); i += every) {
        const Motion motion{course.positions[i], course.velocities[i]};
        decltype(pipeline.step(motion, bar_dt, bar_gravity)) velocities;
        times.push_back(processor_seconds([&] { velocities = pipeline.step(motion, bar_dt, bar_gravity); }));
        off = difference(course.after[i], velocities, stride);
    }
    return median(times);
}

// Each pipeline by itself, so that none finds the caches full of another's numbers; in turns, so that all meet the same
// weather.
StepTimes time_steps(const Bundle& bundle, int iterations, bool quick) {
    Naive naive(bundle, iterations);
    Conventional conventional(bundle, iterations);
    StepTimes times;
    std::vector<double> ours, naives, conventionals, naive_ratios, conventional_ratios;
    for (int round = 0; round < 3; ++round) {
        const Course course = run_ours(bundle, iterations);
        ours.push_back(median(course.seconds));
        conventionals.push_back(run_theirs(conventional, course, 1, 4, times.off_conventional));
        naives.push_back(run_theirs(naive, course, quick ? 50 : 20, 3, times.off_naive));
        conventional_ratios.push_back(conventionals.back() / ours.back());
        naive_ratios.push_back(naives.back() / ours.back());
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

// All memory that must be there while an instance is stepped: its model, which keeps nothing of the bundle but copies,
// its state and its workspace. Shared or not, each is counted once.
double memory_bytes(const Body& body) {
    return static_cast<double>(model_bytes(solver::view_of(body.bundle)) +
                               state_bytes(body.model, solver::Plasticity::additive) + workspace_bytes(body.model));
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
                                m.edge_block.data()->data(),
                                w.gradients.data(),
                                w.blocks.data(),
                                m.ratio,
                                m.is_uniform};
    const solver::RowJob ends{m.slices.node.data(), m.slices.start.data(), m.slices.column.data(),
                              w.damped_mass.data(), w.blocks.data(),       w.inverse.data()};
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
    rows.push_back(row("spmv_ns_per_block" + suffix, bar.name,
                       1e9 * multiply / static_cast<double>(bar.bundle.column.size()), "ns"));
    rows.push_back(row("spmv_fraction" + suffix, bar.name, time_stream(40 * bar.bundle.column.size()) / multiply,
                       "of stream read"));
}

void add_memory(Rows& rows, const Bar& bar) {
    const Body body(bar.bundle);
    const auto tets = static_cast<double>(body.model.tet_count);
    rows.push_back(row("memory_bytes_per_tet", bar.name, memory_bytes(body) / tets, "bytes"));
    // Through the C interface, for a game that reads the file into memory: without the slots of the oracle.
    const double blob = static_cast<double>(write_blob(bar.bundle).size()) - 64 * tets;
    rows.push_back(row("memory_bytes_per_tet_with_blob", bar.name, (memory_bytes(body) + blob) / tets, "bytes"));
}

}
