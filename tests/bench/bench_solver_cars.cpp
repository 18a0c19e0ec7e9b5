// SPDX-License-Identifier: GPL-3.0-or-later
// The sample car in a crash, alone and in company, against the 2 ms that a game may give it.
#include <optional>

#include "bench/bench_solver_rows.h"
#include "bench/second_worker.h"
#include "bench/solver_car.h"
#include "bench/solver_conventional.h"

namespace crumple::bench {
namespace {

constexpr int frames = 60;  // a second: the nose meets the pole in the first of them
constexpr int car_iterations = 20;

// One car; the conventional pipeline makes the same steps from the same states, without contacts and carrier.
void add_one_car(Rows& rows, const std::string& name, const CarModel& shared, int crashes) {
    Garage garage(shared);
    Conventional conventional(shared.bundle, car_iterations);
    std::vector<double> ours, theirs;
    for (int crash = 0; crash < crashes; ++crash) {
        Car car(shared);
        std::vector<std::vector<float>> positions, velocities;
        for (int i = 0; i < frames; ++i) {
            positions.emplace_back(car.state.positions.begin(), car.state.positions.end());
            velocities.emplace_back(car.state.velocities.begin(), car.state.velocities.end());
            ours.push_back(1e3 * processor_seconds([&] { (void)car.drive(shared, garage); }));
        }
        for (std::size_t i = 0; i < frames; ++i) {
            const Motion motion{positions[i], velocities[i]};
            theirs.push_back(1e3 * processor_seconds([&] { (void)conventional.step(motion, bar_dt, 0); }));
        }
    }
    const std::string input = "car_" + std::to_string(shared.model.tet_count) + "_tets";
    rows.push_back(row(name + "_step_ms", input, median(ours), "ms"));
    rows.push_back(row(name + "_step_p99_ms", input, percentile(ours, 99), "ms"));
    rows.push_back(row(name + "_step_ms_per_1k", input,
                       1e3 * median(ours) / static_cast<double>(shared.model.tet_count), "ms per 1k tets"));
    rows.push_back(row(name + "_step_conventional_ms", input, median(theirs), "ms"));
}

// The cars of a frame, a job each. A thread has a garage of its own: the first half of the cars is the caller's.
struct Frame {
    const CarModel& shared;
    std::vector<Car>& cars;
    std::vector<Garage>& garages;

    static void drive(void* of_frame, std::size_t i) {
        const Frame& frame = *static_cast<Frame*>(of_frame);
        const bool is_second = frame.garages.size() > 1 && i >= frame.cars.size() / 2;
        frame.cars[i].drive(frame.shared, frame.garages[is_second ? 1 : 0]);
    }
};

void add_company(Rows& rows, const CarModel& shared, int car_count, std::size_t threads) {
    std::vector<Car> cars;
    for (int i = 0; i < car_count; ++i) cars.emplace_back(shared);
    std::vector<Garage> garages;
    for (std::size_t i = 0; i < threads; ++i) garages.emplace_back(shared);
    std::optional<SecondWorker> second;
    if (threads > 1) second.emplace();
    std::vector<double> times;
    Frame frame{shared, cars, garages};
    for (int i = 0; i < frames; ++i) {
        if (second) {
            const solver::Jobs jobs = second->jobs();
            times.push_back(1e3 * second->seconds_of([&] { jobs.run(jobs.user, cars.size(), Frame::drive, &frame); }));
        } else {
            times.push_back(1e3 * processor_seconds([&] {
                                for (std::size_t k = 0; k < cars.size(); ++k) Frame::drive(&frame, k);
                            }));
        }
    }
    const std::string name = "cars_" + std::to_string(car_count) + '_' + std::to_string(threads) + 't';
    rows.push_back(row(name, "car", median(times), "ms a frame"));
    rows.push_back(row(name + "_p99", "car", percentile(times, 99), "ms a frame"));
}

}

void add_cars(Rows& rows, bool quick) {
    const CarModel shared(cook_car());
    add_one_car(rows, "car", shared, quick ? 1 : 3);
    // Of about the 2,500 tets that 0.5 ms at 0.20 ms per 1,000 are: fewer than its shell alone makes.
    add_one_car(rows, "car_coarse", CarModel(cook_car({"import.cage=13"})), quick ? 1 : 3);
    for (const int cars : {1, 8, 20}) {
        for (const std::size_t threads : {1, 2}) add_company(rows, shared, cars, threads);
    }
}

}
