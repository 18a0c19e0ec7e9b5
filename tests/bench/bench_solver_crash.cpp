// SPDX-License-Identifier: GPL-3.0-or-later
// The sample car into a pole, a second at 120 steps: what the shapes of its tets, as finish.mode leaves them, do to the
// solver.
#include <algorithm>
#include <cmath>

#include "bench/bench_solver_rows.h"
#include "bench/solver_car.h"
#include "geometry/measures.h"
#include "quality/critical_step.h"
#include "quality/element_stiffness.h"
#include "solver/measure.h"

namespace crumple::bench {
namespace {

constexpr float dt = 1.0f / 120;
constexpr int steps = 120;
constexpr double residual = 1e-3;
constexpr std::uint32_t most_iterations = 5000;

// Of carrier and nodes together, seen from the world.
double energy_of(const CarModel& shared, const Car& car) {
    const solver::CarrierMotion motion = car.body.motion();
    const solver::Frame frame(motion);
    double kinetic = 0;
    for (std::size_t i = 0; i < shared.model.node_count; ++i) {
        const Vec3 arm = frame.to_world(solver::widen(position(car.state, i)));
        const Vec3 v = motion.velocity + cross(motion.angular_velocity, arm) +
                       frame.to_world(solver::widen(velocity(car.state, i)));
        kinetic += 0.5 * static_cast<double>(shared.bundle.mass[i]) * dot(v, v);
    }
    return kinetic + elastic_energy(shared.model, car.state, solver::EnergyRotation::of_state);
}

double deepest_dent(const CarModel& shared, const Car& car) {
    double deepest = 0;
    for (std::size_t i = 0; i < shared.model.node_count; ++i) {
        const Vec3f way = position(car.state, i) - shared.bundle.rest_positions[i];
        deepest = std::max(deepest, static_cast<double>(length(way)));
    }
    return deepest;
}

std::size_t count_inverted(const CarModel& shared, const Car& car) {
    std::size_t count = 0;
    for (std::size_t t = 0; t < shared.model.tet_count; ++t) {
        count += determinant(deformation_gradient(shared.model, car.state, t)) <= 0 ? 1 : 0;
    }
    return count;
}

// What a step needs when none is cut short, and what then comes of it.
void add_iterations(Rows& rows, const std::string& input, const CarModel& shared, Garage& garage) {
    solver::Settings settings;
    settings.tolerance = residual;
    settings.max_iterations = most_iterations;
    Car car(shared);
    std::vector<double> counts;
    for (int i = 0; i < steps; ++i) counts.push_back(car.drive(shared, garage, dt, settings).step.iterations);
    rows.push_back(row("crash_iterations_median", input, median(counts), "to a residual of 1e-3"));
    rows.push_back(row("crash_iterations_p90", input, percentile(counts, 90), "to a residual of 1e-3"));
    rows.push_back(row("crash_iterations_most", input, percentile(counts, 100), "to a residual of 1e-3"));
    rows.push_back(row("crash_dent_solved", input, deepest_dent(shared, car), "m"));
}

// With the 20 iterations a step that a game has.
void add_course(Rows& rows, const std::string& input, const CarModel& shared, Garage& garage) {
    Car car(shared);
    const double start = energy_of(shared, car);
    double most = start;
    std::vector<double> times;
    for (int i = 0; i < steps; ++i) {
        times.push_back(1e3 * processor_seconds([&] { (void)car.drive(shared, garage, dt); }));
        most = std::max(most, energy_of(shared, car));
    }
    rows.push_back(row("crash_step_ms", input, median(times), "ms"));
    rows.push_back(row("crash_step_p99_ms", input, percentile(times, 99), "ms"));
    rows.push_back(row("crash_energy_most", input, most / start, "of the start's"));
    rows.push_back(row("crash_dent", input, deepest_dent(shared, car), "m"));
    rows.push_back(row("crash_inverted_at_end", input, static_cast<double>(count_inverted(shared, car)), "tets"));
}

// As if all of it were of the first material.
void add_largest_step(Rows& rows, const std::string& input, const Bundle& bundle) {
    std::vector<Vec3> positions;
    for (const Vec3f& p : bundle.rest_positions) positions.push_back(solver::widen(p));
    double volume = 0;
    for (const auto& [a, b, c, d] : bundle.tets) {
        volume += signed_volume(positions[a], positions[b], positions[c], positions[d]);
    }
    const Material& m = bundle.materials.front();
    const double sound = std::sqrt(m.young_pa / m.density_kg_m3);
    const double step_m = quality::critical_step(quality::assemble(positions, bundle.tets));
    const double regular_m = quality::regular_step(volume / static_cast<double>(bundle.tets.size()));
    rows.push_back(row("crash_largest_step", input, 1e6 * step_m / sound, "us", step_m / regular_m));
}

}

void add_crash(Rows& rows, const std::string& finish_mode) {
    // Without finish a car has tets that no gate lets pass.
    const CarModel shared(cook_car({"finish.mode=" + finish_mode, "gates.enforce=false"}));
    Garage garage(shared);
    const std::string input = "car_" + std::to_string(shared.model.tet_count) + "_tets_" + finish_mode;
    add_iterations(rows, input, shared, garage);
    add_course(rows, input, shared, garage);
    add_largest_step(rows, input, shared.bundle);
}

}
