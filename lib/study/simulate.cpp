// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/simulate.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/error.h"
#include "report/number_text.h"
#include "study/frame.h"
#include "study/outcome.h"
#include "study/player.h"

namespace crumple::study {

namespace {

Bundle with_scaled_materials(Bundle bundle, const Scene& scene) {
    for (Material& m : bundle.materials) {
        m.young_pa *= scene.young_scale;
        m.yield_pa *= scene.yield_scale;
        m.creep_per_s *= scene.creep_scale;
        m.beta_s *= scene.damping_scale;
    }
    return bundle;
}

[[noreturn]] void leave_the_finite(double time_s) {
    throw Error(ErrorKind::bad_input, "at " + report::number_text(time_s, 3) +
                                          " s the run is beyond what floats can hold; it takes less speed and turning, "
                                          "more steps_per_s or a smaller young_scale");
}

StepTimes times_of(std::vector<double> ms) {
    if (ms.empty()) return {};
    std::sort(ms.begin(), ms.end());
    const auto at = [&](double part) {
        return ms[static_cast<std::size_t>(part * static_cast<double>(ms.size() - 1))];
    };
    return {at(0.5), at(0.99), ms.back()};
}

// Of one step, by the wall.
double step_and_time(Player& player, double time_s, double dt) {
    const auto begin = std::chrono::steady_clock::now();
    player.step(time_s, static_cast<float>(dt));
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

void add_frame(Player& player, double time_s, Run& run) {
    run.frames.push_back(take_frame(player, time_s, time_s - run.frames.back().time_s));
    if (!is_finite(run.frames.back())) leave_the_finite(time_s);
}

}

Run simulate(const Bundle& cooked, const Scene& scene, const Context& context) {
    check_params(scene);
    const Bundle bundle = with_scaled_materials(cooked, scene);
    Player player(bundle, scene, context);
    Run run;
    run.steps = static_cast<std::uint32_t>(std::lround(scene.seconds * scene.steps_per_s));
    run.frames.push_back(take_frame(player, 0, 0));
    const double dt = 1 / scene.steps_per_s;
    const double frame_count = scene.seconds * scene.frames_per_s;
    std::vector<double> ms;
    for (std::uint32_t i = 0; i < run.steps; ++i) {
        context.stop_if_cancelled();
        const double step_ms = step_and_time(player, i * dt, dt);
        if (!player.report().is_asleep) ms.push_back(step_ms);
        const std::uint32_t warnings = player.report().step.warnings;
        if ((warnings & solver::step_bad_input) != 0) leave_the_finite(i * dt);
        run.warned_steps += warnings != 0;
        // Frame k is the first step at or behind its time.
        const double done = (i + 1.0) / run.steps;
        const auto due = static_cast<std::size_t>(std::floor(done * frame_count + 1e-9));
        if (due >= run.frames.size() || i + 1 == run.steps) add_frame(player, (i + 1) * dt, run);
        context.tell_progress("simulate", done);
    }
    run.times = times_of(std::move(ms));
    judge_outcome(player, run);
    return run;
}

}
