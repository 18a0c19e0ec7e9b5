// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/solver_naive.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <vector>

namespace crumple::bench {
namespace {

using Matrix12 = Eigen::Matrix<double, 12, 12>;
using Vector12 = Eigen::Matrix<double, 12, 1>;

struct Element {
    Eigen::Matrix<double, 3, 4> gradients;
    Matrix12 stiffness;
    Vector12 rest;
    double beta_s;
};

Element element_of(const Bundle& b, std::size_t t) {
    const Material& m = b.materials[b.material[t]];
    const double young = m.young_pa * static_cast<double>(b.stiffness_scale[t]);
    const double mu = young / (2 * (1 + m.poisson));
    const double lambda = young * m.poisson / ((1 + m.poisson) * (1 - 2 * m.poisson));
    Element e;
    e.beta_s = m.beta_s;
    auto& g = e.gradients;
    for (int i = 0; i < 4; ++i) {
        const Vec3f x = b.rest_positions[b.tets[t][static_cast<std::size_t>(i)]];
        e.rest.segment<3>(3 * i) << x.x, x.y, x.z;
        for (int k = 0; k < 3 && i > 0; ++k) g(k, i) = b.inverse_rest[t][static_cast<std::size_t>(3 * (i - 1) + k)];
    }
    g.col(0) = -g.rightCols<3>().rowwise().sum();
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            e.stiffness.block<3, 3>(3 * i, 3 * j) =
                b.volume[t] *
                (lambda * g.col(i) * g.col(j).transpose() + mu * g.col(i).dot(g.col(j)) * Eigen::Matrix3d::Identity() +
                 mu * g.col(j) * g.col(i).transpose());
        }
    }
    return e;
}

Eigen::Matrix3d rotation_of(const Eigen::Matrix3d& f) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d u = svd.matrixU();
    if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) *= -1;
    return u * svd.matrixV().transpose();
}

}

struct Naive::Data {
    const Bundle& bundle;
    int iterations;
    std::vector<Element> elements;
    Eigen::VectorXd velocities;

    [[nodiscard]] bool is_locked(int row) const { return bundle.locked[static_cast<std::size_t>(row) / 3] != 0; }

    void add_tet(const Motion& from, std::size_t t, double dt, std::vector<Eigen::Triplet<double>>& entries,
                 Eigen::VectorXd& right) const {
        const Tet& tet = bundle.tets[t];
        const Element& e = elements[t];
        Vector12 x;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t k = 0; k < 3; ++k)
                x[static_cast<Eigen::Index>(3 * i + k)] = from.positions[4 * std::size_t{tet[i]} + k];
        }
        const Eigen::Matrix3d r =
            rotation_of(Eigen::Map<const Eigen::Matrix<double, 3, 4>>(x.data()) * e.gradients.transpose());
        Matrix12 turn = Matrix12::Zero();
        for (int i = 0; i < 4; ++i) turn.block<3, 3>(3 * i, 3 * i) = r;
        const Matrix12 k = turn * e.stiffness * turn.transpose();
        const Vector12 force = -turn * (e.stiffness * (turn.transpose() * x - e.rest));
        const double scale = dt * (e.beta_s + dt);
        for (int i = 0; i < 12; ++i) {
            const int row = static_cast<int>(3 * tet[static_cast<std::size_t>(i / 3)]) + i % 3;
            right[row] += dt * force[i];
            for (int j = 0; j < 12; ++j) {
                entries.emplace_back(row, static_cast<int>(3 * tet[static_cast<std::size_t>(j / 3)]) + j % 3,
                                     scale * k(i, j));
            }
        }
    }
};

Naive::Naive(const Bundle& bundle, int iterations) : data_(new Data{bundle, iterations, {}, {}}) {
    for (std::size_t t = 0; t < bundle.solver_tet_count; ++t) data_->elements.push_back(element_of(bundle, t));
}

Naive::~Naive() = default;

std::span<const double> Naive::step(const Motion& from, double dt, double gravity_y) {
    const Bundle& b = data_->bundle;
    const auto size = static_cast<Eigen::Index>(3 * b.mass.size());
    const double alpha_per_s = b.materials[0].alpha_per_s;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(144 * b.solver_tet_count + static_cast<std::size_t>(size));
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size), before(size);
    for (std::size_t i = 0; i < b.mass.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int row = static_cast<int>(3 * i + k);
            before[row] = from.velocities[4 * i + k];
            right[row] = b.mass[i] * (before[row] + (k == 1 ? dt * gravity_y : 0.0));
            entries.emplace_back(row, row, b.mass[i] * (1 + alpha_per_s * dt));
        }
    }
    for (std::size_t t = 0; t < data_->elements.size(); ++t) data_->add_tet(from, t, dt, entries, right);
    // Locked rows and columns become those of the identity.
    std::erase_if(entries, [&](const auto& e) { return data_->is_locked(e.row()) != data_->is_locked(e.col()); });
    for (Eigen::Index row = 0; row < size; ++row) {
        if (data_->is_locked(static_cast<int>(row))) right[row] = before[row] = 0;
    }
    Eigen::SparseMatrix<double> a(size, size);
    a.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> cg(a);
    cg.setMaxIterations(data_->iterations);
    cg.setTolerance(1e-30);
    data_->velocities = cg.solveWithGuess(right, before);
    return {data_->velocities.data(), static_cast<std::size_t>(size)};
}

}
