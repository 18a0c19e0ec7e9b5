// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/outcome.h"

#include <algorithm>

#include "solver/measure.h"
#include "solver/rotation.h"

namespace crumple::study {

namespace {

using solver::Mat3d;

// Where a body would be if it had only moved as a whole.
struct RigidFit {
    Mat3d turn = Mat3d::identity();
    Vec3 from, to;
    [[nodiscard]] Vec3 place(Vec3 rest) const { return to + turn * (rest - from); }
};

Mat3d nearest_rotation(const Mat3d& m) {
    solver::Mat3 narrow;
    for (std::size_t i = 0; i < 9; ++i) narrow.m[i] = static_cast<float>(m.m[i]);
    const solver::Mat3 turn = rotation_svd_smallest(narrow, solver::Mat3::identity());
    Mat3d wide;
    for (std::size_t i = 0; i < 9; ++i) wide.m[i] = static_cast<double>(turn.m[i]);
    return wide;
}

// The rigid motion that fits the nodes best, by their masses.
RigidFit fit_rigidly(const Player& player) {
    const Bundle& bundle = player.bundle();
    RigidFit fit;
    double mass = 0;
    for (std::size_t n = 0; n < player.model().node_count; ++n) {
        const double m = bundle.mass[n];
        fit.from += widen(bundle.rest_positions[n]) * m;
        fit.to += widen(position(player.state(), n)) * m;
        mass += m;
    }
    fit.from = fit.from / mass;
    fit.to = fit.to / mass;
    Mat3d moved;
    for (std::size_t n = 0; n < player.model().node_count; ++n) {
        const double m = bundle.mass[n] / mass;
        moved = moved + solver::outer(widen(position(player.state(), n)) - fit.to,
                                      (widen(bundle.rest_positions[n]) - fit.from) * m);
    }
    fit.turn = nearest_rotation(moved);
    return fit;
}

// Only a body that nothing holds moves as a whole in its frame.
bool is_held(const Player& player) { return player.has_locks() || !player.handles().empty(); }

void measure_dents(const Player& player, Run& run) {
    const Bundle& bundle = player.bundle();
    const Box box = box_of(bundle);
    const RigidFit whole = is_held(player) ? RigidFit{} : fit_rigidly(player);
    for (std::size_t n = 0; n < player.model().node_count; ++n) {
        const Vec3 rest = widen(bundle.rest_positions[n]);
        const double way = length(widen(position(player.state(), n)) - whole.place(rest));
        if (bundle.locked[n] && player.handles().empty()) {
            run.locked_drift = std::max(run.locked_drift, way / length(box.high - box.low));
        }
        run.deepest_dent_m = std::max(run.deepest_dent_m, way);
    }
}

// Tets that handles turn inside out against each other or against locked nodes.
std::uint32_t count_driven_inside_out(const Player& player) {
    if (player.handles().empty()) return 0;
    std::vector<std::uint8_t> is_driven = player.bundle().locked;
    for (const auto& handle : player.handles()) {
        for (const Index n : handle->nodes) is_driven[n] = 1;
    }
    std::uint32_t count = 0;
    for (std::size_t t = 0; t < player.model().tet_count; ++t) {
        const Tet& tet = player.bundle().tets[t];
        const bool is_all_driven = std::all_of(tet.begin(), tet.end(), [&](Index n) { return is_driven[n] != 0; });
        count += is_all_driven && determinant(deformation_gradient(player.model(), player.state(), t)) <= 0;
    }
    return count;
}

void add_findings(Run& run) {
    if (run.warned_steps > 0) {
        run.findings.push_back(
            {"RUN_WARNED",
             Severity::warning,
             "steps were too stiff for float, not finite or cut short: smaller steps or a softer material",
             run.warned_steps,
             {}});
    }
    if (run.inverted_at_end > 0) {
        run.findings.push_back(
            {"RUN_INVERTED", Severity::warning, "tets are inside out at the end", run.inverted_at_end, {}});
    }
    if (run.driven_inside_out > 0) {
        run.findings.push_back({"RUN_HANDLES_CROSS",
                                Severity::warning,
                                "of these tets have no free node: handles move them through each other or through "
                                "locked nodes; move the handles less or give them smaller boxes",
                                run.driven_inside_out,
                                {}});
    }
}

}

void judge_outcome(const Player& player, Run& run) {
    measure_dents(player, run);
    run.driven_inside_out = count_driven_inside_out(player);
    run.inverted_at_end = run.frames.back().inverted;
    add_findings(run);
}

}
