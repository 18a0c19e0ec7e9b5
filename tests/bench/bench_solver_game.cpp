// SPDX-License-Identifier: GPL-3.0-or-later
// What a game feels besides a step: sleepers, skinning, the caller's threads.
#include <atomic>
#include <cstring>
#include <thread>

#include "bench/bench_solver_rows.h"
#include "bench/cpu_time.h"
#include "solver/body.h"
#include "solver/instance.h"
#include "solver/skin.h"

namespace crumple::bench {
namespace {

using solver::test::Body;
using solver::test::grid_body;

Row row(const std::string& name, const std::string& input, double value, const std::string& unit,
        std::optional<double> ratio = std::nullopt) {
    return {name, input, {{"value", value}, {"unit", unit}, {"ratio", ratio}}};
}

Material bodywork() {
    Material m = solver::test::elastic_material(1e6, 0.3);
    m.yield_pa = 2e4;
    m.alpha_per_s = 1;
    m.beta_s = 0.004;
    return m;
}

Bundle car_sized() {
    return grid_body({18, 9, 9}, {0.25f, 0.2f, 0.15f}, bodywork(), [](Vec3f p) { return p.x > 4; });
}

// Read of as many bytes, the wider of the two directions a vertex moves.
double read_seconds(std::size_t bytes) {
    const std::vector<std::uint64_t> data(bytes / 8, 1);
    double best = 1e30;
    volatile std::uint64_t sink = 0;
    for (int round = 0; round < 10; ++round) {
        best = std::min(best, seconds([&] {
                            std::uint64_t sums[8] = {};
                            for (std::size_t i = 0; i + 8 <= data.size(); i += 8) {
                                for (std::size_t k = 0; k < 8; ++k) sums[k] += data[i + k];
                            }
                            sink = sums[0] + sums[1] + sums[2] + sums[3] + sums[4] + sums[5] + sums[6] + sums[7];
                        }));
    }
    (void)sink;
    return best;
}

// Two workers for one body: the second waits for work without sleeping, as those of a game do within a frame.
class SecondWorker {
public:
    SecondWorker() : thread_([this] { work(); }) {}
    ~SecondWorker() {
        is_over_ = true;
        thread_.join();
    }
    [[nodiscard]] solver::Jobs jobs() {
        return {[](void* user, std::size_t count, solver::Jobs::Task task, void* context) {
                    static_cast<SecondWorker*>(user)->run(count, task, context);
                },
                this};
    }

private:
    void run(std::size_t count, solver::Jobs::Task task, void* context) {
        task_ = task;
        context_ = context;
        count_ = count;
        next_ = 0;
        is_done_ = false;
        round_.fetch_add(1, std::memory_order_release);
        take();
        while (!is_done_.load(std::memory_order_acquire)) {
        }
    }
    void take() {
        for (std::size_t i = next_++; i < count_; i = next_++) task_(context_, i);
    }
    void work() {
        unsigned seen = 0;
        while (!is_over_) {
            const unsigned round = round_.load(std::memory_order_acquire);
            if (round == seen) continue;
            seen = round;
            take();
            is_done_.store(true, std::memory_order_release);
        }
    }
    solver::Jobs::Task task_ = nullptr;
    void* context_ = nullptr;
    std::size_t count_ = 0;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<unsigned> round_ = 0;
    std::atomic<bool> is_done_ = true, is_over_ = false;
    std::thread thread_;
};

}

void add_asleep(std::vector<Row>& rows) {
    Body body(car_sized());
    std::vector<solver::Constraint> room(body.node_count());
    solver::Obstacle wall;
    wall.axis = {1, 0, 0};
    wall.position = {-5, 0, 0};
    solver::InstanceInput input;
    input.obstacles = {&wall, 1};
    input.room = room;
    const auto step = [&] { return step_instance(body.model, body.state, body.workspace, input, body.settings); };
    for (int i = 0; i < 3000 && !step().is_asleep; ++i) {
    }
    constexpr int steps = 100000;
    const double begin = cpu_seconds();
    for (int i = 0; i < steps; ++i) step();
    const double time = (cpu_seconds() - begin) / steps;
    rows.push_back(row("asleep_us", "car_sized", is_asleep(body.state) ? 1e6 * time : -1, "us"));
}

void add_skin(std::vector<Row>& rows) {
    constexpr std::size_t count = 100000;
    Body body(car_sized());
    std::vector<Index> tet(count);
    std::vector<std::array<float, 4>> weights(count, {0.25f, 0.25f, 0.25f, 0.25f});
    std::vector<Vec3f> rest(count, {0, 1, 0}), positions(count), normals(count);
    // A drawn mesh is as local as the tets it hangs on.
    for (std::size_t v = 0; v < count; ++v) tet[v] = static_cast<Index>(v * body.bundle.tets.size() / count);
    const solver::VisualView view{body.bundle.tets, tet, weights};
    body.step(1.0f / 60);
    double best = 1e30;
    for (int round = 0; round < 30; ++round) {
        best = std::min(
            best, seconds([&] {
                skin(body.model, body.state, view, {rest, {}}, {positions, normals, {}}, {0, count}, body.settings);
            }));
    }
    rows.push_back(row("skin_100k", "grid", read_seconds(88 * count) / best, "of memory bandwidth"));
    rows.push_back(row("skin_100k_ms", "grid", 1e3 * best, "ms"));
}

void add_two_threads(std::vector<Row>& rows, const Bundle& bundle, std::uint32_t iterations) {
    solver::Settings settings;
    settings.max_iterations = iterations;
    settings.plasticity = solver::Plasticity::off;
    Body body(bundle, settings);
    solver::StepInput input;
    input.gravity = {0, -9.88f, 0};
    SecondWorker worker;
    std::vector<double> ratios, times;
    for (int i = 0; i < 30; ++i) {
        const double alone = seconds([&] { body.step(input); });
        const double together = seconds([&] { body.step(input, worker.jobs()); });
        if (i < 5) continue;
        ratios.push_back(alone / together);
        times.push_back(1e3 * together);
    }
    rows.push_back(row("two_threads_50k", "beam_50k", median(times), "ms", median(ratios)));
}

}
