// SPDX-License-Identifier: GPL-3.0-or-later
// What the steps come to: how soon a scrambled body is whole again (Table 1 of Civit-Flores and Susin 2014), and where
// a loaded bar comes to rest beside CalculiX on the same mesh.
#include <algorithm>
#include <cmath>

#include "bench/bench_solver_rows.h"
#include "reference/calculix_figures.h"
#include "reference/reference.h"
#include "solver/body.h"

namespace crumple::bench {
namespace {

using solver::RotationMethod;
using solver::Settings;
using solver::Treatment;
using solver::test::Body;

constexpr double given_up_s = 20;

// Simulated seconds until all det F > 0 and |R^T F - I| < .1 everywhere, from nodes at random places of the unit cube
// of cells^3 cubes; given_up_s where it never is.
double recovery_time(const Bundle& bundle, const Settings& settings, std::uint64_t seed) {
    Body body(bundle, settings);
    Rng rng(seed);
    body.set_positions([&](Vec3f) { return (solver::test::random_vector(rng) + Vec3f{1, 1, 1}) * 0.5f; });
    for (int i = 1; i * static_cast<double>(bar_dt) < given_up_s; ++i) {
        body.step(bar_dt);
        if (is_whole(body)) return i * static_cast<double>(bar_dt);
    }
    return given_up_s;
}

struct Recovery {
    double median_s = 0;
    double p95_s = 0;
    double recovered = 0;  // part of the seeds
};

Recovery recover(int cells, RotationMethod rotation, Treatment treatment, int seeds) {
    Settings settings;
    settings.rotation = rotation;
    settings.treatment = treatment;
    settings.plasticity = solver::Plasticity::off;
    // As good as an exact solve.
    settings.max_iterations = 1000;
    settings.tolerance = 1e-5;
    const float size = 1.0f / static_cast<float>(cells);
    const Bundle bundle =
        solver::test::grid_body({cells, cells, cells}, {size, size, size}, solver::test::elastic_material(1e5, 0.3));
    std::vector<double> times;
    for (int seed = 0; seed < seeds; ++seed) {
        times.push_back(recovery_time(bundle, settings, static_cast<std::uint64_t>(seed)));
    }
    std::sort(times.begin(), times.end());
    const auto whole = std::count_if(times.begin(), times.end(), [](double t) { return t < given_up_s; });
    return {median(times), times[times.size() * 95 / 100], static_cast<double>(whole) / seeds};
}

// The nodes of the bar's free end, and the force k = P L^2 / (E I) = 1 spread over them.
struct Load {
    explicit Load(const Bundle& bar) {
        for (std::size_t n = 0; n < bar.rest_positions.size(); ++n) {
            if (bar.rest_positions[n].x == 8) nodes.push_back(n);
        }
        force_y = -1e6 / 12 / 64 / static_cast<double>(nodes.size());
    }
    // Mean way of these nodes.
    template <class Position>
    [[nodiscard]] Vec3 way(const Bundle& bar, Position&& position) const {
        Vec3 sum;
        for (const std::size_t n : nodes) {
            const Vec3f rest = bar.rest_positions[n];
            sum += position(n) - Vec3{rest.x, rest.y, rest.z};
        }
        return sum / static_cast<double>(nodes.size());
    }
    std::vector<std::size_t> nodes;
    double force_y = 0;
};

Vec3 tip_at_rest(const Bundle& bar) {
    Bundle bundle = bar;
    bundle.materials[0].alpha_per_s = 2;
    Settings settings;
    settings.max_iterations = 3000;
    settings.tolerance = 1e-6;
    settings.plasticity = solver::Plasticity::off;
    Body body(std::move(bundle), settings);
    const Load load(bar);
    std::vector<Vec3f> forces(body.node_count());
    for (const std::size_t n : load.nodes) forces[n].y = static_cast<float>(load.force_y);
    solver::StepInput input;
    input.dt = 0.05f;
    input.forces = forces;
    for (int i = 0; i < 1200; ++i) body.step(input);
    return load.way(bar, [&](std::size_t n) {
        const Vec3f x = body.x(n);
        return Vec3{x.x, x.y, x.z};
    });
}

// By Green's strain, which is CalculiX's.
Vec3 green_tip_at_rest(const Bundle& bar) {
    const Load load(bar);
    std::vector<Vec3> forces(bar.rest_positions.size());
    for (const std::size_t n : load.nodes) forces[n].y = load.force_y;
    reference::Body body = reference::body_at_rest(bar);
    if (!settle_by_green(body, forces, 1e-7)) return {};
    return load.way(bar, [&](std::size_t n) { return body.positions[n]; });
}

}

void add_scramble(Rows& rows, int seeds) {
    const Recovery reflect = recover(4, RotationMethod::apd, Treatment::reflect, seeds);
    const Recovery svd = recover(4, RotationMethod::svd_smallest, Treatment::off, seeds);
    rows.push_back(row("scramble", "cube_384", reflect.median_s, "s", reflect.median_s / svd.median_s));
    rows.push_back(row("scramble_recovered", "cube_384", reflect.recovered, "of the seeds"));
}

void add_recovery_table(Rows& rows, int seeds) {
    for (const int cells : {4, 6}) {
        for (const Way& way : ways) {
            const Recovery r = recover(cells, way.rotation, way.treatment, seeds);
            const std::string input = "cube_" + std::to_string(6 * cells * cells * cells) + '_' + way.name;
            rows.push_back(row("table1_median", input, r.median_s, "s"));
            rows.push_back(row("table1_p95", input, r.p95_s, "s"));
            rows.push_back(row("table1_recovered", input, r.recovered, "of the seeds"));
        }
    }
}

void add_tip_error(Rows& rows, const Bar& bar) {
    constexpr calculix::Tip truth = calculix::bar_5k_tips[1];
    static_assert(truth.k == 1);
    if (!bar.is_tetgen) {
        rows.push_back(
            {"tip_error", bar.name, {{"value", std::nullopt}, {"unit", "of the way"}, {"ratio", std::nullopt}}});
        return;
    }
    const Vec3 tip = tip_at_rest(bar.bundle);
    rows.push_back(row("tip_error", bar.name, std::fabs(tip.y / truth.down - 1), "of the way"));
    rows.push_back(
        row("tip_error_stvk", bar.name, std::fabs(green_tip_at_rest(bar.bundle).y / truth.down - 1), "of the way"));
    rows.push_back(row("tip_error_along", bar.name, std::fabs(tip.x / truth.along - 1), "of the way"));
}

}
