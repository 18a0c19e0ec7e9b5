// SPDX-License-Identifier: GPL-3.0-or-later
// Rotations of eight and sixteen elements at a time, and of elements that are inverted half of the time.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "bench/bench_solver_rows.h"
#include "solver/body.h"

namespace crumple::bench {
namespace {

using solver::Isa;
using solver::packet_size;
using solver::RotationMethod;
using solver::Settings;
using solver::Treatment;
using solver::test::Body;

struct RotationSet {
    std::vector<solver::RotationPacket> packets;
    std::vector<Eigen::Matrix3f> f;
};

RotationSet rotation_set(double low, double high, double off_rad) {
    constexpr std::size_t count = 8192;
    RotationSet set{std::vector<solver::RotationPacket>(count / packet_size), {}};
    Rng rng(8);
    for (std::size_t i = 0; i < count; ++i) {
        const auto stretch = [&] { return static_cast<float>(low + (high - low) * rng.next_unit()); };
        const float a = stretch();
        const float b = stretch();
        const solver::Mat3 s{{a, 0, 0, 0, b, 0, 0, 0, stretch()}};
        const solver::Mat3 v = solver::test::random_rotation(rng);
        const solver::Mat3 r = solver::test::random_rotation(rng);
        const solver::Mat3 f = r * (v * s * transpose(v));
        const auto q = solver::to_quaternion(solver::test::turn(solver::test::random_vector(rng), off_rad) * r);
        solver::RotationPacket& packet = set.packets[i / packet_size];
        for (std::size_t k = 0; k < 9; ++k) packet.f[k][i % packet_size] = f.m[k];
        const float values[4] = {q.x, q.y, q.z, q.w};
        for (std::size_t k = 0; k < 4; ++k) packet.rotation[k][i % packet_size] = values[k];
        set.f.push_back(Eigen::Map<const Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(f.m.data()));
    }
    return set;
}

double time_jacobi(const RotationSet& set) {
    volatile float sink = 0;
    return best_of(3, [&] {
        for (const auto& f : set.f) {
            const Eigen::JacobiSVD<Eigen::Matrix3f> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
            sink = (svd.matrixU() * svd.matrixV().transpose())(0, 0);
        }
    });
}

// S2: independent tets whose fourth corner swings through its face, half of the time on the wrong side, against a
// swing that stays on the right one. Each begins anywhere in its swing, so those that share a register are not inside
// out together. Time of all that is done per tet, rotation, force and gradients: ns, median of the steps.
double time_swings(RotationMethod rotation, Treatment treatment, bool is_inverting) {
    constexpr Index count = 8192;
    std::vector<Vec3f> positions;
    std::vector<Tet> tets;
    for (Index t = 0; t < count; ++t) {
        for (const Vec3f p : {Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}}) positions.push_back(p);
        tets.push_back({4 * t, 4 * t + 1, 4 * t + 2, 4 * t + 3});
    }
    Settings settings;
    settings.treatment = treatment;
    Body body(solver::test::bundle_of(positions, tets, solver::test::elastic_material()), settings);
    solver::ElementJob job{
        body.model.packets.data(),    body.state.tets.data(),          nullptr,
        body.state.positions.data(),  body.state.velocities.data(),    body.workspace.gradients.data(),
        body.workspace.forces.data(), body.workspace.materials.data(), {}};
    job.settings.dt = job.settings.last_dt = 0.01f;
    job.settings.treatment = treatment;
    if (rotation != RotationMethod::apd) job.settings.rotation = rotation_function(rotation);
    job.settings.plasticity = solver::Plasticity::off;
    const auto& k = solver::kernels(solver::best_isa());
    Rng rng(2);
    std::vector<double> begun(count);
    for (double& turns : begun) turns = rng.next_unit();
    std::vector<double> times;
    for (int i = 0; i < 1000; ++i) {
        for (Index t = 0; t < count; ++t) {
            const double phase = 6.2831853 * (i / 100.0 + begun[t]);
            const std::size_t at = 4 * (4 * std::size_t{t} + 3) + 2;
            const auto z = static_cast<float>(is_inverting ? std::cos(phase) : 1 + 0.3 * std::cos(phase));
            body.state.velocities[at] = (z - body.state.positions[at]) / 0.01f;
            body.state.positions[at] = z;
        }
        times.push_back(processor_seconds([&] { k.elements(job, 0, body.model.packets.size()); }));
    }
    return 1e9 * median(times) / count;
}

}

void add_rotations(Rows& rows, const std::string& name, Isa isa) {
    if (solver::best_isa(isa) != isa) return;
    double worst_ns = 0, least_ratio = 1e30;
    for (const auto& set : {rotation_set(0.8, 1.25, 0.0524), rotation_set(0.3, 2, 0.1745)}) {
        auto packets = set.packets;
        double time = 1e30;
        for (int round = 0; round < 30; ++round) {
            packets = set.packets;  // the last rotation as far off as the first time
            time = std::min(
                time, processor_seconds([&] { solver::kernels(isa).rotations(packets.data(), 0, packets.size()); }));
        }
        worst_ns = std::max(worst_ns, 1e9 * time / 8192);
        least_ratio = std::min(least_ratio, time_jacobi(set) / time);
    }
    rows.push_back(row(name, "sets_ab_8k", worst_ns, "ns", least_ratio));
}

void add_half_inverted(Rows& rows) {
    const double upright = time_swings(RotationMethod::apd, Treatment::reflect, false);
    const double reflect = time_swings(RotationMethod::apd, Treatment::reflect, true);
    const double project = time_swings(RotationMethod::apd, Treatment::project, true);
    rows.push_back(row("half_inverted", "swing_8k", reflect, "ns", reflect / upright));
    rows.push_back(row("half_inverted_project", "swing_8k", project, "ns", project / upright));
}

void add_rotation_table(Rows& rows) {
    for (const Way& way : ways) {
        for (const bool is_inverting : {false, true}) {
            rows.push_back(row(is_inverting ? "table3_half_inverted" : "table3_upright", way.name,
                               time_swings(way.rotation, way.treatment, is_inverting), "ns"));
        }
    }
}

}
