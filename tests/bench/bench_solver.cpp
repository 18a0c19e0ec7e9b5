// SPDX-License-Identifier: GPL-3.0-or-later
// The runtime solver against a naive one that makes the same steps of the same beam from the same states: double,
// Eigen's JacobiSVD, R K R^T as 12 x 12 products, triplets, Eigen's conjugate gradients.
// ratio = theirs / ours for step_*, rotation_* and two_threads_*, ours / theirs for half_inverted and scramble.
#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "bench/bench.h"
#include "bench/bench_solver_rows.h"
#include "bench/cpu_time.h"
#include "solver/body.h"

namespace crumple::bench {
namespace {

using solver::Isa;
using solver::packet_size;
using solver::Settings;
using solver::test::Body;
using solver::test::grid_body;

// Everything here runs on one thread, so processor time is the time it takes on a machine that does nothing else.
template <class Work>
double processor_seconds(Work&& work) {
    const double begin = cpu_seconds();
    work();
    return cpu_seconds() - begin;
}

constexpr float step_dt = 1.0f / 60;
constexpr float gravity = -9.88f;

Bundle beam(int cells) {
    Material m = solver::test::elastic_material(1e6, 0.3);
    m.alpha_per_s = 0.15;
    m.beta_s = 0.004;
    const float size = 8.0f / static_cast<float>(cells);
    const int across = static_cast<int>(std::lround(1 / size));
    const float side = 1.0f / static_cast<float>(across);
    return grid_body({cells, across, across}, {size, side, side}, m, [](Vec3f p) { return p.x == 0; });
}

solver::StepInput falling() {
    solver::StepInput input;
    input.dt = step_dt;
    input.gravity = {0, gravity, 0};
    return input;
}

Settings budget(std::uint32_t iterations, Isa isa = Isa::automatic) {
    Settings settings;
    settings.max_iterations = iterations;
    settings.plasticity = solver::Plasticity::off;
    settings.isa = isa;
    return settings;
}

// ---- naive

class Naive {
public:
    Naive(const Bundle& bundle, int iterations) : b_(bundle), iterations_(iterations) {
        for (std::size_t t = 0; t < b_.solver_tet_count; ++t) prepare(t);
    }

    void step(const Body& from) {
        const auto size = static_cast<Eigen::Index>(3 * from.node_count());
        std::vector<Eigen::Triplet<double>> entries;
        entries.reserve(144 * b_.solver_tet_count);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(size), before(size);
        for (std::size_t i = 0; i < from.node_count(); ++i) {
            const Vec3f v = velocity(from.state, i);
            for (int k = 0; k < 3; ++k) {
                const int row = static_cast<int>(3 * i) + k;
                before[row] = v[k];
                right[row] = b_.mass[i] * (v[k] + (k == 1 ? step_dt * gravity : 0.0));
                entries.emplace_back(row, row, b_.mass[i] * (1 + 0.15 * step_dt));
            }
        }
        for (std::size_t t = 0; t < b_.solver_tet_count; ++t) add_tet(from, t, entries, right);
        // Locked rows and columns become those of the identity.
        std::erase_if(entries, [&](const auto& e) { return is_locked(e.row()) != is_locked(e.col()); });
        for (Eigen::Index row = 0; row < size; ++row) {
            if (is_locked(static_cast<int>(row))) right[row] = before[row] = 0;
        }
        Eigen::SparseMatrix<double> a(size, size);
        a.setFromTriplets(entries.begin(), entries.end());
        Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> cg(a);
        cg.setMaxIterations(iterations_);
        cg.setTolerance(1e-30);
        velocities = cg.solveWithGuess(right, before);
    }

    Eigen::VectorXd velocities;

private:
    using Matrix12 = Eigen::Matrix<double, 12, 12>;
    using Vector12 = Eigen::Matrix<double, 12, 1>;

    [[nodiscard]] bool is_locked(int row) const { return b_.locked[static_cast<std::size_t>(row) / 3] != 0; }

    void prepare(std::size_t t) {
        const Material& m = b_.materials[0];
        const double mu = m.young_pa / (2 * (1 + m.poisson));
        const double lambda = m.young_pa * m.poisson / ((1 + m.poisson) * (1 - 2 * m.poisson));
        Eigen::Matrix<double, 3, 4> g;
        Vector12 rest;
        for (int i = 0; i < 4; ++i) {
            const Vec3f x = b_.rest_positions[b_.tets[t][static_cast<std::size_t>(i)]];
            rest.segment<3>(3 * i) << x.x, x.y, x.z;
            for (int k = 0; k < 3 && i > 0; ++k)
                g(k, i) = b_.inverse_rest[t][static_cast<std::size_t>(3 * (i - 1) + k)];
        }
        g.col(0) = -g.rightCols<3>().rowwise().sum();
        Matrix12 k;
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j) {
                k.block<3, 3>(3 * i, 3 * j) =
                    b_.volume[t] *
                    (lambda * g.col(i) * g.col(j).transpose() +
                     mu * g.col(i).dot(g.col(j)) * Eigen::Matrix3d::Identity() + mu * g.col(j) * g.col(i).transpose());
            }
        }
        gradients_.push_back(g);
        stiffness_.push_back(k);
        rest_.push_back(rest);
    }

    void add_tet(const Body& from, std::size_t t, std::vector<Eigen::Triplet<double>>& entries,
                 Eigen::VectorXd& right) {
        const Tet& tet = b_.tets[t];
        Vector12 x;
        for (int i = 0; i < 4; ++i) {
            const Vec3f p = from.x(tet[static_cast<std::size_t>(i)]);
            x.segment<3>(3 * i) << p.x, p.y, p.z;
        }
        const Eigen::Matrix3d f = Eigen::Map<const Eigen::Matrix<double, 3, 4>>(x.data()) * gradients_[t].transpose();
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
        Eigen::Matrix3d u = svd.matrixU();
        if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) *= -1;
        const Eigen::Matrix3d r = u * svd.matrixV().transpose();
        Matrix12 turn = Matrix12::Zero();
        for (int i = 0; i < 4; ++i) turn.block<3, 3>(3 * i, 3 * i) = r;
        const Matrix12 k = turn * stiffness_[t] * turn.transpose();
        const Vector12 force = -turn * (stiffness_[t] * (turn.transpose() * x - rest_[t]));
        const double scale = step_dt * (0.004 + step_dt);
        for (int i = 0; i < 12; ++i) {
            const int row = static_cast<int>(3 * tet[static_cast<std::size_t>(i / 3)]) + i % 3;
            right[row] += step_dt * force[i];
            for (int j = 0; j < 12; ++j) {
                entries.emplace_back(row, static_cast<int>(3 * tet[static_cast<std::size_t>(j / 3)]) + j % 3,
                                     scale * k(i, j));
            }
        }
    }

    const Bundle& b_;
    int iterations_;
    std::vector<Eigen::Matrix<double, 3, 4>> gradients_;
    std::vector<Matrix12> stiffness_;
    std::vector<Vector12> rest_;
};

// ---- the beam

// Milliseconds a step of both, from the same states, steps 10 to 110 from rest.
struct StepTimes {
    double ours = 0, naive = 0;
    double difference = 0;  // of their velocities, relative, at the last step
};

StepTimes time_steps(int cells, std::uint32_t iterations, bool quick) {
    const Bundle bundle = beam(cells);
    Body body(bundle, budget(iterations));
    Naive naive(bundle, static_cast<int>(iterations));
    const int every = quick ? 25 : 10;
    StepTimes times;
    std::vector<double> ours, theirs;
    for (int i = 0; i < 110; ++i) {
        const bool is_compared = i >= 10 && (i - 10) % every == 0;
        if (is_compared) theirs.push_back(processor_seconds([&] { naive.step(body); }));
        const double time = processor_seconds([&] { body.step(falling()); });
        if (i >= 10) ours.push_back(time);
        if (!is_compared) continue;
        double off = 0, size = 0;
        for (std::size_t n = 0; n < body.node_count(); ++n) {
            const Vec3f v = velocity(body.state, n);
            for (int k = 0; k < 3; ++k) {
                off += std::pow(v[k] - naive.velocities[static_cast<Eigen::Index>(3 * n) + k], 2);
                size += v[k] * v[k];
            }
        }
        times.difference = std::sqrt(off / size);
    }
    times.ours = 1e3 * median(ours);
    times.naive = 1e3 * median(theirs);
    return times;
}

Row row(const std::string& name, const std::string& input, double value, const std::string& unit,
        std::optional<double> ratio = std::nullopt) {
    return {name, input, {{"value", value}, {"unit", unit}, {"ratio", ratio}}};
}

void add_steps(std::vector<Row>& rows, const std::string& size, int cells, std::uint32_t iterations, bool quick) {
    const StepTimes times = time_steps(cells, iterations, quick);
    const double thousands = beam(cells).solver_tet_count / 1e3;
    rows.push_back(
        row("step_" + size, "beam_" + size, times.ours / thousands, "ms per 1k tets", times.naive / times.ours));
    rows.push_back(row("step_" + size + "_naive", "beam_" + size, times.naive / thousands, "ms per 1k tets"));
    rows.push_back(row("step_" + size + "_difference", "beam_" + size, times.difference, "of the velocities"));
}

// ---- kernels alone

double best_of(int rounds, const std::function<void()>& work) {
    double best = 1e30;
    for (int i = 0; i < rounds; ++i) best = std::min(best, processor_seconds(work));
    return best;
}

double time_stream(std::size_t bytes) {
    std::vector<float> array(bytes / 4, 1.0f);
    using Wide = float __attribute__((vector_size(64), aligned(4)));
    volatile float sink = 0;
    return best_of(20, [&] {
        Wide sums[4] = {};
        for (std::size_t i = 0; i + 64 <= array.size(); i += 64) {
            for (std::size_t k = 0; k < 4; ++k) {
                Wide some;
                std::memcpy(&some, &array[i + 16 * k], sizeof some);
                sums[k] += some;
            }
        }
        sink = sums[0][0] + sums[1][0] + sums[2][0] + sums[3][0];
    });
}

void add_kernels(std::vector<Row>& rows, const std::string& size, int cells) {
    Body body(beam(cells), budget(20));
    for (int i = 0; i < 20; ++i) body.step(falling());
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
    const double assembly = best_of(50, [&] {
        k.edges(edges, 0, m.edge_count);
        k.rows(ends, 0, m.node_count);
    });
    rows.push_back(
        row("assembly_ns_per_tet_" + size, "beam_" + size, 1e9 * assembly / static_cast<double>(m.tet_count), "ns"));
    const solver::SolveJob solve{m.bundle.row_start.data(), m.bundle.column.data(), w.is_fixed.data(), w.blocks.data(),
                                 w.inverse.data(),          w.change.data(),        w.residual.data(), w.precise.data(),
                                 w.direction.data(),        w.product.data()};
    const double multiply = best_of(100, [&] { k.multiply(solve, 0, m.node_count); });
    rows.push_back(
        row("spmv_ns_per_block_" + size, "beam_" + size, 1e9 * multiply / static_cast<double>(m.block_count), "ns"));
    rows.push_back(
        row("spmv_fraction_" + size, "beam_" + size, time_stream(40 * m.block_count) / multiply, "of stream read"));
    const double bytes =
        static_cast<double>(model_bytes(m.bundle) + state_bytes(m, solver::Plasticity::additive) + workspace_bytes(m) +
                            m.block_count * 4 + m.node_count * 24 + m.edge_count * 12);
    rows.push_back(
        row("memory_bytes_per_tet_" + size, "beam_" + size, bytes / static_cast<double>(m.tet_count), "bytes"));
}

// ---- rotations

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

void add_rotations(std::vector<Row>& rows, const std::string& name, Isa isa) {
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

// S2: independent tets whose fourth corner swings through its face, half of the time on the wrong side, against a
// swing that stays on the right one. Time of all that is done per tet, rotation, force and gradients.
double time_swings(solver::Treatment treatment, bool is_inverting) {
    constexpr Index count = 8192;
    std::vector<Vec3f> positions;
    std::vector<Tet> tets;
    for (Index t = 0; t < count; ++t) {
        for (const Vec3f p : {Vec3f{0, 0, 0}, Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}}) positions.push_back(p);
        tets.push_back({4 * t, 4 * t + 1, 4 * t + 2, 4 * t + 3});
    }
    Settings settings = budget(1);
    settings.treatment = treatment;
    Body body(solver::test::bundle_of(positions, tets, solver::test::elastic_material()), settings);
    solver::ElementJob job{
        body.model.packets.data(),    body.state.tets.data(),          nullptr,
        body.state.positions.data(),  body.state.velocities.data(),    body.workspace.gradients.data(),
        body.workspace.forces.data(), body.workspace.materials.data(), {}};
    job.settings.dt = job.settings.last_dt = 0.01f;
    job.settings.treatment = treatment;
    job.settings.plasticity = solver::Plasticity::off;
    const auto& k = solver::kernels(solver::best_isa());
    double total = 0;
    constexpr int steps = 200;
    for (int i = 0; i < steps; ++i) {
        for (Index t = 0; t < count; ++t) {
            const double phase = 6.2831853 * (i / 100.0 + t / 8192.0);
            const std::size_t at = 4 * (4 * std::size_t{t} + 3) + 2;
            const auto z = static_cast<float>(is_inverting ? std::cos(phase) : 1 + 0.3 * std::cos(phase));
            body.state.velocities[at] = (z - body.state.positions[at]) / 0.01f;
            body.state.positions[at] = z;
        }
        total += processor_seconds([&] { k.elements(job, 0, body.model.packets.size()); });
    }
    return 1e9 * total / steps / count;
}

// ---- S1

double median_recovery(const Settings& settings, int seeds) {
    std::vector<double> times;
    for (int seed = 0; seed < seeds; ++seed) {
        Body body(grid_body({4, 4, 4}, {0.25f, 0.25f, 0.25f}, solver::test::elastic_material(1e5, 0.3)), settings);
        Rng rng(static_cast<std::uint64_t>(seed));
        body.set_positions([&](Vec3f) { return (solver::test::random_vector(rng) + Vec3f{1, 1, 1}) * 0.5f; });
        double time = 20;
        for (int i = 1; i < 1200; ++i) {
            body.step(step_dt);
            bool is_whole = true;
            for (std::size_t t = 0; t < body.model.tet_count && is_whole; ++t) {
                const auto f = deformation_gradient(body.model, body.state, t);
                const auto r = solver::rotation_svd_smallest(f, solver::Mat3::identity());
                is_whole = determinant(f) > 0 && norm(transpose(r) * f - solver::Mat3::identity()) < 0.1f;
            }
            if (is_whole) {
                time = i * static_cast<double>(step_dt);
                break;
            }
        }
        times.push_back(time);
    }
    return median(times);
}

void add_scramble(std::vector<Row>& rows, int seeds) {
    Settings settings = budget(1000);
    settings.tolerance = 1e-5;
    const double reflect = median_recovery(settings, seeds);
    settings.treatment = solver::Treatment::off;
    settings.rotation = solver::RotationMethod::svd_smallest;
    rows.push_back(row("scramble", "cube_384", reflect, "s", reflect / median_recovery(settings, seeds)));
}

using AddRows = std::function<void(std::vector<Row>&)>;

void add(const std::string& name, const AddRows& add_rows) {
    add_once("solver/" + name, [add_rows] {
        std::vector<Row> rows;
        add_rows(rows);
        return rows;
    });
}

void add_half_inverted(std::vector<Row>& rows) {
    const double upright = time_swings(solver::Treatment::reflect, false);
    const double reflect = time_swings(solver::Treatment::reflect, true);
    const double project = time_swings(solver::Treatment::project, true);
    rows.push_back(row("half_inverted", "swing_8k", reflect, "ns", reflect / upright));
    rows.push_back(row("half_inverted_project", "swing_8k", project, "ns", project / upright));
}

void add_all(bool quick) {
    add("step_5k", [quick](auto& rows) { add_steps(rows, "5k", 36, 22, quick); });
    add("kernels_5k", [](auto& rows) { add_kernels(rows, "5k", 36); });
    if (!quick) {
        add("step_50k", [quick](auto& rows) { add_steps(rows, "50k", 80, 48, quick); });
        add("kernels_50k", [](auto& rows) { add_kernels(rows, "50k", 80); });
    }
    add("rotation_8", [](auto& rows) { add_rotations(rows, "rotation_8", Isa::avx2); });
    add("rotation_16", [](auto& rows) { add_rotations(rows, "rotation_16", Isa::avx512); });
    add("half_inverted", add_half_inverted);
    add("asleep_us", add_asleep);
    add("skin_100k", add_skin);
    if (!quick) {
        add("two_threads_50k", [](auto& rows) { add_two_threads(rows, beam(80), 48); });
    }
    add("scramble", [quick](auto& rows) { add_scramble(rows, quick ? 11 : 100); });
}

}
}

int main(int argc, char** argv) { return crumple::bench::run(argc, argv, crumple::bench::add_all); }
