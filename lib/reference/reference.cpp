// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/reference.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace crumple::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Stiffness = Eigen::Matrix<double, 12, 12>;
using Gradients = Eigen::Matrix<double, 3, 4>;  // column i: gradient of the weight of corner i

Vector3d eigen(Vec3 a) { return {a.x, a.y, a.z}; }
Vec3 plain(const Vector3d& a) { return {a.x(), a.y(), a.z()}; }
Matrix3d eigen(const Matrix3& a) { return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(a.data()); }
Matrix3 plain(const Matrix3d& a) {
    Matrix3 result;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(result.data()) = a;
    return result;
}

struct Lame {
    double lambda, mu;
};

// A secant below 1 is what flow leaves of the shear stiffness; volume keeps its own.
Lame lame_of(const Bundle& b, std::size_t tet, double secant = 1) {
    const Material& m = b.materials[b.material[tet]];
    const double young = m.young_pa * b.stiffness_scale[tet];
    const double mu = young / (2 * (1 + m.poisson));
    return {young * m.poisson / ((1 + m.poisson) * (1 - 2 * m.poisson)) + 2.0 / 3 * mu * (1 - secant), mu * secant};
}

// Straight from the rest positions: the bundle's float inverse is not the truth.
Matrix3d rest_edges(const Bundle& b, std::size_t tet) {
    Matrix3d dm;
    const auto corner = [&](std::size_t i) {
        const Vec3f p = b.rest_positions[b.tets[tet][i]];
        return Vector3d(p.x, p.y, p.z);
    };
    for (int i = 0; i < 3; ++i) dm.col(i) = corner(static_cast<std::size_t>(i) + 1) - corner(0);
    return dm;
}

double volume_of(const Bundle& b, std::size_t tet) { return rest_edges(b, tet).determinant() / 6; }

Gradients gradients_of(const Bundle& b, std::size_t tet) {
    const Matrix3d inverse = rest_edges(b, tet).inverse();
    Gradients g;
    g.rightCols<3>() = inverse.transpose();
    g.col(0) = -g.rightCols<3>().rowwise().sum();
    return g;
}

Matrix3d edges_of(const std::vector<Vec3>& x, const Tet& tet) {
    Matrix3d ds;
    for (int i = 0; i < 3; ++i) ds.col(i) = eigen(x[tet[static_cast<std::size_t>(i) + 1]] - x[tet[0]]);
    return ds;
}

Matrix3d nearest(const Matrix3d& f) {
    const Eigen::JacobiSVD<Matrix3d> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix3d u = svd.matrixU();
    if ((u * svd.matrixV().transpose()).determinant() < 0) u.col(2) *= -1;
    return u * svd.matrixV().transpose();
}

// K_ij = V [lambda g_i g_j^T + mu (g_i . g_j) I + mu g_j g_i^T]
Stiffness rest_stiffness(const Bundle& b, std::size_t tet, double secant) {
    const Gradients g = gradients_of(b, tet);
    const auto [lambda, mu] = lame_of(b, tet, secant);
    Stiffness k;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            k.block<3, 3>(3 * i, 3 * j) = lambda * g.col(i) * g.col(j).transpose() +
                                          mu * g.col(i).dot(g.col(j)) * Matrix3d::Identity() +
                                          mu * g.col(j) * g.col(i).transpose();
        }
    }
    return volume_of(b, tet) * k;
}

Stiffness turned_stiffness(const Bundle& b, std::size_t tet, const Matrix3d& r, double secant) {
    Stiffness turn = Stiffness::Zero();
    for (int i = 0; i < 4; ++i) turn.block<3, 3>(3 * i, 3 * i) = r;
    return turn * rest_stiffness(b, tet, secant) * turn.transpose();
}

// eps = sym(R^T F) - I - eps_p
Matrix3d elastic_strain(const Matrix3d& r, const Matrix3d& f, const Matrix3d& plastic) {
    const Matrix3d s = r.transpose() * f;
    return 0.5 * (s + s.transpose()) - Matrix3d::Identity() - plastic;
}

// f_i = -V R (lambda tr(eps) I + 2 mu eps) g_i
void add_elastic_force(const Bundle& b, std::size_t tet, const Matrix3d& r, const Matrix3d& strain, double secant,
                       std::vector<Vec3>& forces) {
    const auto [lambda, mu] = lame_of(b, tet, secant);
    const Matrix3d stress = lambda * strain.trace() * Matrix3d::Identity() + 2 * mu * strain;
    const Gradients f = -volume_of(b, tet) * r * stress * gradients_of(b, tet);
    for (int i = 0; i < 4; ++i) forces[b.tets[tet][static_cast<std::size_t>(i)]] += plain(Vector3d(f.col(i)));
}

Matrix3d deviator(const Matrix3d& strain) { return strain - strain.trace() / 3 * Matrix3d::Identity(); }

// eps_p + c dt / (1 + c dt) (1 - y / |d|) d with d the deviatoric elastic strain and c the creep.
Matrix3d flowed(const Body& body, std::size_t tet, const Matrix3d& strain, double dt) {
    const Material& m = body.bundle->materials[body.bundle->material[tet]];
    const double yield = std::sqrt(2.0 / 3) * m.yield_pa / (2 * lame_of(*body.bundle, tet).mu);
    const Matrix3d before = eigen(body.plastic[tet]);
    const Matrix3d d = deviator(strain);
    if (d.norm() <= yield) return before;
    const double flow = m.creep_per_s * dt;
    Matrix3d p = before + flow / (1 + flow) * (1 - yield / d.norm()) * d;
    if (p.norm() > m.max_plastic_strain) p *= m.max_plastic_strain / p.norm();
    return p;
}

// What the flow of this step will leave of the shear stiffness: by the secant to the strain where the step linearizes,
// x + (beta + dt) v.
double secant_of(const Body& body, std::size_t tet, const Matrix3d& r, const Matrix3d& strain, double dt) {
    const Bundle& b = *body.bundle;
    const Matrix3d rate = r.transpose() * edges_of(body.velocities, b.tets[tet]) * rest_edges(b, tet).inverse();
    const double ahead = b.materials[b.material[tet]].beta_s + dt;
    const Matrix3d there = strain + ahead * 0.5 * (rate + rate.transpose());
    const Matrix3d gone = flowed(body, tet, there, dt) - eigen(body.plastic[tet]);
    const Matrix3d d = deviator(there);
    return d.norm() > 0 ? std::max(1e-3, 1 - gone.cwiseProduct(d).sum() / d.squaredNorm()) : 1;
}

// alpha m of each node, mass-weighted over its tets.
std::vector<double> mass_damping(const Bundle& b) {
    std::vector<double> damping(b.rest_positions.size(), 0), mass(b.rest_positions.size(), 0);
    for (std::size_t t = 0; t < b.solver_tet_count; ++t) {
        const Material& m = b.materials[b.material[t]];
        for (const Index node : b.tets[t]) {
            mass[node] += m.density_kg_m3 * b.volume[t];
            damping[node] += m.density_kg_m3 * b.volume[t] * m.alpha_per_s;
        }
    }
    for (std::size_t i = 0; i < damping.size(); ++i) damping[i] = mass[i] > 0 ? damping[i] / mass[i] * b.mass[i] : 0;
    return damping;
}

using Sparse = Eigen::SparseMatrix<double>;

Sparse sparse_of(const Bundle& b, std::span<const double> blocks) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(blocks.size());
    for (Index row = 0; row < b.diagonal.size(); ++row) {
        for (Index k = b.row_start[row]; k < b.row_start[row + 1]; ++k) {
            for (int i = 0; i < 9; ++i) {
                entries.emplace_back(static_cast<int>(3 * row) + i % 3, static_cast<int>(3 * b.column[k]) + i / 3,
                                     blocks[9 * static_cast<std::size_t>(k) + static_cast<std::size_t>(i)]);
            }
        }
    }
    const auto size = static_cast<Eigen::Index>(3 * b.diagonal.size());
    Sparse a(size, size);
    a.setFromTriplets(entries.begin(), entries.end());
    return a;
}

// x with A x = b where `free`, x as given elsewhere: the fixed part moves to the right side.
Eigen::VectorXd solve_free(const Sparse& a, const Eigen::VectorXd& b, const std::vector<std::uint8_t>& is_fixed,
                           Eigen::VectorXd x) {
    std::vector<int> number(static_cast<std::size_t>(x.size()), -1);
    int count = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (is_fixed[i / 3]) continue;
        x[static_cast<Eigen::Index>(i)] = 0;
        number[i] = count++;
    }
    const Eigen::VectorXd right = b - a * x;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd reduced(count);
    for (Eigen::Index column = 0; column < a.outerSize(); ++column) {
        const int j = number[static_cast<std::size_t>(column)];
        if (j < 0) continue;
        reduced[j] = right[column];
        for (Sparse::InnerIterator entry(a, column); entry; ++entry) {
            const int i = number[static_cast<std::size_t>(entry.row())];
            if (i >= 0) entries.emplace_back(i, j, entry.value());
        }
    }
    Sparse free(count, count);
    free.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Sparse> factors(free);
    if (factors.info() != Eigen::Success) {
        throw Error(ErrorKind::bad_input,
                    "reference: the matrix is singular; lock nodes or give every free node a mass");
    }
    const Eigen::VectorXd solution = factors.solve(reduced);
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] >= 0) x[static_cast<Eigen::Index>(i)] = solution[number[i]];
    }
    return x;
}

Eigen::VectorXd stacked(const std::vector<Vec3>& rows) {
    Eigen::VectorXd all(3 * static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) all.segment<3>(3 * static_cast<Eigen::Index>(i)) = eigen(rows[i]);
    return all;
}

Vec3 row_of(const Eigen::VectorXd& all, std::size_t i) {
    return plain(Vector3d(all.segment<3>(3 * static_cast<Eigen::Index>(i))));
}

void add_to_slots(const Bundle& b, std::size_t tet, const Stiffness& k, std::vector<double>& blocks) {
    for (std::size_t slot = 0; slot < 16; ++slot) {
        const auto i = static_cast<Eigen::Index>(slot / 4), j = static_cast<Eigen::Index>(slot % 4);
        Eigen::Map<Matrix3d> block(&blocks[9 * static_cast<std::size_t>(b.element_slots[tet][slot])]);
        block += k.block<3, 3>(3 * i, 3 * j);
    }
}

// Green's strain E = (F^T F - I) / 2, P = F (lambda tr(E) I + 2 mu E): adds the forces -V P g_i, and their derivatives
// with the sign turned, to the blocks.
void add_green(const Body& body, std::size_t tet, std::vector<Vec3>& forces, std::vector<double>& blocks) {
    const Bundle& b = *body.bundle;
    const auto [lambda, mu] = lame_of(b, tet);
    const double volume = volume_of(b, tet);
    const Gradients g = gradients_of(b, tet);
    const Matrix3d f = eigen(deformation_gradient(body, tet));
    const auto stress_of = [l = lambda, m = mu](const Matrix3d& e) {
        return Matrix3d(l * e.trace() * Matrix3d::Identity() + 2 * m * e);
    };
    const Matrix3d stress = stress_of(0.5 * (f.transpose() * f - Matrix3d::Identity()));
    const Gradients pull = volume * f * stress * g;
    for (int i = 0; i < 4; ++i) forces[b.tets[tet][static_cast<std::size_t>(i)]] += plain(Vector3d(-pull.col(i)));
    Stiffness k;
    for (int column = 0; column < 12; ++column) {
        const Matrix3d df = Vector3d::Unit(column % 3) * g.col(column / 3).transpose();
        const Matrix3d strain = 0.5 * (f.transpose() * df + df.transpose() * f);
        const Gradients change = volume * (df * stress + f * stress_of(strain)) * g;
        k.col(column) = Eigen::Map<const Eigen::Matrix<double, 12, 1>>(change.data());
    }
    add_to_slots(b, tet, k, blocks);
}

// Moves the free nodes and returns how far, as a part of the whole way from rest.
double move_free(Body& body, const std::vector<double>& blocks, const std::vector<Vec3>& right) {
    const Bundle& b = *body.bundle;
    const Eigen::VectorXd move = solve_free(sparse_of(b, blocks), stacked(right), b.locked,
                                            Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * right.size())));
    double way = 0;
    for (std::size_t n = 0; n < right.size(); ++n) {
        body.positions[n] += row_of(move, n);
        const Vec3f rest = b.rest_positions[n];
        const Vec3 moved = body.positions[n] - Vec3{rest.x, rest.y, rest.z};
        way += dot(moved, moved);
    }
    return way > 0 ? move.norm() / std::sqrt(way) : 0;
}

std::vector<double> blocks_of(const Bundle& b, std::span<const Matrix3> rotations, std::span<const double> scale_of_tet,
                              std::span<const double> secants) {
    std::vector<double> blocks(9 * b.column.size(), 0.0);
    for (std::size_t t = 0; t < b.solver_tet_count; ++t) {
        add_to_slots(b, t, scale_of_tet[t] * turned_stiffness(b, t, eigen(rotations[t]), secants[t]), blocks);
    }
    return blocks;
}

struct Elements {
    std::vector<Vec3> forces;     // N
    std::vector<double> secants;  // S
};

// Turns `body.rotations` to the nearest ones and lets plastic strain flow on the way.
Elements update_elements(Body& body, const StepInput& input) {
    Elements result{std::vector<Vec3>(body.positions.size()), std::vector<double>(body.rotations.size(), 1.0)};
    for (std::size_t t = 0; t < body.rotations.size(); ++t) {
        const Matrix3d f = eigen(deformation_gradient(body, t));
        const Matrix3d r = input.is_linear ? Matrix3d(Matrix3d::Identity()) : nearest(f);
        if (input.has_plasticity) {
            body.plastic[t] = plain(flowed(body, t, elastic_strain(r, f, eigen(body.plastic[t])), input.dt));
        }
        const Matrix3d strain = elastic_strain(r, f, eigen(body.plastic[t]));
        if (input.has_plasticity) result.secants[t] = secant_of(body, t, r, strain, input.dt);
        add_elastic_force(*body.bundle, t, r, strain, result.secants[t], result.forces);
        body.rotations[t] = plain(r);
    }
    return result;
}

}

Body body_at_rest(const Bundle& bundle) {
    Body body;
    body.bundle = &bundle;
    for (const Vec3f p : bundle.rest_positions) body.positions.push_back({p.x, p.y, p.z});
    body.velocities.resize(body.positions.size());
    body.rotations.assign(bundle.solver_tet_count, {1, 0, 0, 0, 1, 0, 0, 0, 1});
    body.plastic.assign(bundle.solver_tet_count, Matrix3{});
    return body;
}

Matrix3 nearest_rotation(const Matrix3& f) { return plain(nearest(eigen(f))); }

Matrix3 deformation_gradient(const Body& body, std::size_t tet) {
    return plain(Matrix3d(edges_of(body.positions, body.bundle->tets[tet]) * rest_edges(*body.bundle, tet).inverse()));
}

std::vector<Vec3> elastic_forces(const Body& body) {
    Body copy = body;
    return update_elements(copy, {}).forces;
}

std::vector<double> stiffness_by_slots(const Bundle& b, std::span<const Matrix3> rotations,
                                       std::span<const double> scale_of_tet) {
    return blocks_of(b, rotations, scale_of_tet, std::vector<double>(b.solver_tet_count, 1.0));
}

// (M (1 + alpha dt) + (beta dt + dt^2) K') v+ = M v + dt (f + f_elastic)
std::vector<Vec3> step(Body& body, const StepInput& input) {
    const Bundle& b = *body.bundle;
    const std::size_t node_count = body.positions.size();
    Elements elements = update_elements(body, input);
    std::vector<Vec3>& right = elements.forces;
    std::vector<double> scale(body.rotations.size());
    for (std::size_t t = 0; t < scale.size(); ++t) {
        scale[t] = input.dt * (b.materials[b.material[t]].beta_s + input.dt);
    }
    std::vector<double> blocks = blocks_of(b, body.rotations, scale, elements.secants);
    const std::vector<double> damping = mass_damping(b);
    for (std::size_t i = 0; i < node_count; ++i) {
        const double mass = b.mass[i];
        for (const std::size_t k : {0, 4, 8}) {
            blocks[9 * static_cast<std::size_t>(b.diagonal[i]) + k] += mass + input.dt * damping[i];
        }
        if (!input.forces.empty()) right[i] += input.forces[i];
        right[i] = mass * body.velocities[i] + input.dt * (right[i] + mass * input.gravity);
    }
    std::vector<std::uint8_t> is_fixed = b.locked;
    std::vector<Vec3> known(node_count);
    for (const Prescribed& p : input.prescribed) {
        is_fixed[p.node] = 1;
        known[p.node] = p.velocity;
    }
    const Sparse a = sparse_of(b, blocks);
    const Eigen::VectorXd load = stacked(right);
    const Eigen::VectorXd v = solve_free(a, load, is_fixed, stacked(known));
    const Eigen::VectorXd unbalanced = a * v - load;
    std::vector<Vec3> reactions(node_count);
    for (std::size_t i = 0; i < node_count; ++i) {
        body.velocities[i] = row_of(v, i);
        body.positions[i] += input.dt * body.velocities[i];
        if (is_fixed[i]) reactions[i] = row_of(unbalanced, i) / input.dt;
    }
    return reactions;
}

std::optional<int> settle(Body& body, std::span<const Vec3> forces, double relative_tolerance, bool is_linear) {
    constexpr int max_steps = 2000;
    StepInput input;
    input.is_linear = is_linear;
    const std::vector<double> scale(body.rotations.size(), 1.0);
    for (int i = 0; i < max_steps; ++i) {
        std::vector<Vec3> right = update_elements(body, input).forces;
        for (std::size_t n = 0; n < right.size(); ++n) right[n] += forces[n];
        const std::vector<double> blocks = stiffness_by_slots(*body.bundle, body.rotations, scale);
        if (move_free(body, blocks, right) <= relative_tolerance) return i;
    }
    return std::nullopt;
}

std::optional<int> settle_by_green(Body& body, std::span<const Vec3> forces, double relative_tolerance,
                                   int load_steps) {
    constexpr int max_newton_steps = 50;
    int steps = 0;
    for (int part = 1; part <= load_steps; ++part) {
        bool is_settled = false;
        for (int i = 0; i < max_newton_steps && !is_settled; ++i, ++steps) {
            std::vector<Vec3> right(forces.begin(), forces.end());
            for (Vec3& f : right) f = f * (static_cast<double>(part) / load_steps);
            std::vector<double> blocks(9 * body.bundle->column.size(), 0.0);
            for (std::size_t t = 0; t < body.rotations.size(); ++t) add_green(body, t, right, blocks);
            is_settled = move_free(body, blocks, right) <= relative_tolerance;
        }
        if (!is_settled) return std::nullopt;
    }
    return steps;
}

}
