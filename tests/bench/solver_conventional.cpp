// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/solver_conventional.h"

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace crumple::bench {
namespace {

constexpr int width = 8;
using Wide = float __attribute__((vector_size(4 * width)));
using Quad = float __attribute__((vector_size(16)));

Wide all(float x) { return Wide{} + x; }
Wide root(Wide a) {
    Wide r;
    for (int l = 0; l < width; ++l) r[l] = std::sqrt(a[l]);
    return r;
}
Wide absolute(Wide a) { return a < 0 ? -a : a; }
Wide largest(Wide a, Wide b) { return a > b ? a : b; }

// Row-major.
using Matrix = std::array<Wide, 9>;
using Column = std::array<Wide, 3>;

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            c[3 * i + j] = a[3 * i] * b[j] + a[3 * i + 1] * b[3 + j] + a[3 * i + 2] * b[6 + j];
    }
    return c;
}

Matrix product_with_transpose(const Matrix& a, const Matrix& b) {
    Matrix c;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            c[3 * i + j] = a[3 * i] * b[3 * j] + a[3 * i + 1] * b[3 * j + 1] + a[3 * i + 2] * b[3 * j + 2];
    }
    return c;
}

Column column(const Matrix& a, std::size_t c) { return {a[c], a[3 + c], a[6 + c]}; }
Wide dot(const Column& a, const Column& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Column cross(const Column& a, const Column& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Column unit(const Column& a) {
    const Wide over = 1 / root(largest(dot(a, a), all(1e-30f)));
    return {a[0] * over, a[1] * over, a[2] * over};
}

// One Jacobi rotation of the symmetric s in the plane (p, q), taken along by the columns of v.
template <std::size_t p, std::size_t q>
void jacobi(Matrix& s, Matrix& v) {
    constexpr std::size_t r = 3 - p - q;
    const Wide off = s[3 * p + q];
    const Wide tau = (s[4 * q] - s[4 * p]) / (2 * off);
    Wide t = 1 / (absolute(tau) + root(1 + tau * tau));
    t = tau < 0 ? -t : t;
    t = absolute(off) > 1e-20f ? t : all(0);
    const Wide c = 1 / root(1 + t * t);
    const Wide sine = t * c;
    s[4 * p] -= t * off;
    s[4 * q] += t * off;
    s[3 * p + q] = s[3 * q + p] = all(0);
    const Wide rp = s[3 * r + p], rq = s[3 * r + q];
    s[3 * r + p] = s[3 * p + r] = c * rp - sine * rq;
    s[3 * r + q] = s[3 * q + r] = sine * rp + c * rq;
    for (std::size_t i = 0; i < 3; ++i) {
        const Wide vp = v[3 * i + p], vq = v[3 * i + q];
        v[3 * i + p] = c * vp - sine * vq;
        v[3 * i + q] = sine * vp + c * vq;
    }
}

// The larger of two columns of v and f v first.
void order(Column& v0, Column& b0, Column& v1, Column& b1) {
    const auto is_less = dot(b0, b0) < dot(b1, b1);
    for (std::size_t i = 0; i < 3; ++i) {
        const Wide v = v0[i], b = b0[i];
        v0[i] = is_less ? v1[i] : v0[i];
        v1[i] = is_less ? v : v1[i];
        b0[i] = is_less ? b1[i] : b0[i];
        b1[i] = is_less ? b : b1[i];
    }
}

// U V^T with the sign on the smallest singular value. Four sweeps, as FEMFX makes.
Matrix nearest_rotation(const Matrix& f) {
    Matrix s;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) s[3 * i + j] = s[3 * j + i] = dot(column(f, i), column(f, j));
    }
    Matrix v{};
    v[0] = v[4] = v[8] = all(1);
    for (int sweep = 0; sweep < 4; ++sweep) {
        jacobi<0, 1>(s, v);
        jacobi<0, 2>(s, v);
        jacobi<1, 2>(s, v);
    }
    const Matrix b = product(f, v);
    Column v0 = column(v, 0), v1 = column(v, 1), v2 = column(v, 2);
    Column b0 = column(b, 0), b1 = column(b, 1), b2 = column(b, 2);
    order(v0, b0, v1, b1);
    order(v0, b0, v2, b2);
    order(v1, b1, v2, b2);
    v2 = cross(v0, v1);
    const Column u0 = unit(b0);
    const Wide along = dot(u0, b1);
    const Column u1 = unit({b1[0] - along * u0[0], b1[1] - along * u0[1], b1[2] - along * u0[2]});
    const Column u2 = cross(u0, u1);
    Matrix r;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) r[3 * i + j] = u0[i] * v0[j] + u1[i] * v1[j] + u2[i] * v2[j];
    }
    return r;
}

// Blocks (i, j) with i <= j of a symmetric 12 x 12 matrix of 3 x 3 blocks.
constexpr std::size_t pairs[10][2] = {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {1, 1}, {1, 2}, {1, 3}, {2, 2}, {2, 3}, {3, 3}};

struct Packet {
    Matrix stiffness[10];  // at rest
    Matrix inverse_rest;
    Wide rest[4][3];
    Wide beta_s;
    Index node[4][width];
    std::array<Index, 16> slots[width];
    int count;  // the rest are padding
};

void fill_lane(Packet& packet, std::size_t lane, const Bundle& b, std::size_t t) {
    const Material& m = b.materials[b.material[t]];
    const double young = m.young_pa * static_cast<double>(b.stiffness_scale[t]);
    const double mu = young / (2 * (1 + m.poisson));
    const double lambda = young * m.poisson / ((1 + m.poisson) * (1 - 2 * m.poisson));
    double g[4][3] = {};
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 1; i < 4; ++i) {
            g[i][k] = b.inverse_rest[t][3 * (i - 1) + k];
            g[0][k] -= g[i][k];
        }
    }
    for (std::size_t p = 0; p < 10; ++p) {
        const double* gi = g[pairs[p][0]];
        const double* gj = g[pairs[p][1]];
        const double inner = gi[0] * gj[0] + gi[1] * gj[1] + gi[2] * gj[2];
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double value = lambda * gi[r] * gj[c] + mu * gj[r] * gi[c] + (r == c ? mu * inner : 0);
                packet.stiffness[p][3 * r + c][lane] = static_cast<float>(static_cast<double>(b.volume[t]) * value);
            }
        }
    }
    for (std::size_t i = 0; i < 9; ++i) packet.inverse_rest[i][lane] = b.inverse_rest[t][i];
    for (std::size_t i = 0; i < 4; ++i) {
        packet.node[i][lane] = b.tets[t][i];
        for (int k = 0; k < 3; ++k)
            packet.rest[i][static_cast<std::size_t>(k)][lane] = b.rest_positions[b.tets[t][i]][k];
    }
    packet.slots[lane] = b.element_slots[t];
    packet.beta_s[lane] = static_cast<float>(m.beta_s);
}

struct Turned {
    Matrix stiffness[10];
    Wide force[4][3];
};

// K' = R K R^T and f = -R K (R^T x - X).
Turned turn(const Packet& packet, const float* positions) {
    Wide x[4][3];
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t l = 0; l < width; ++l) {
            const float* p = positions + 4 * std::size_t{packet.node[i][l]};
            for (std::size_t k = 0; k < 3; ++k) x[i][k][l] = p[k];
        }
    }
    Matrix edges;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < 3; ++i) edges[3 * k + i] = x[i + 1][k] - x[0][k];
    }
    const Matrix r = nearest_rotation(product(edges, packet.inverse_rest));
    Turned result;
    Wide strained[4][3], pulled[4][3] = {};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            strained[i][k] = r[k] * x[i][0] + r[3 + k] * x[i][1] + r[6 + k] * x[i][2] - packet.rest[i][k];
    }
    for (std::size_t p = 0; p < 10; ++p) {
        const Matrix& k = packet.stiffness[p];
        const auto [i, j] = pairs[p];
        result.stiffness[p] = product_with_transpose(product(r, k), r);
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t c = 0; c < 3; ++c) {
                pulled[i][a] += k[3 * a + c] * strained[j][c];
                if (i != j) pulled[j][a] += k[3 * c + a] * strained[i][c];
            }
        }
    }
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            result.force[i][k] = -(r[3 * k] * pulled[i][0] + r[3 * k + 1] * pulled[i][1] + r[3 * k + 2] * pulled[i][2]);
    }
    return result;
}

Quad load(const float* p) {
    Quad q;
    std::memcpy(&q, p, sizeof q);
    return q;
}
void store(float* p, Quad q) { std::memcpy(p, &q, sizeof q); }

}

struct Conventional::Data {
    const Bundle& bundle;
    int iterations;
    std::vector<Packet> packets;
    std::vector<float> blocks;   // column-major, 9 each, and room to read over the end
    std::vector<float> inverse;  // N x 3 columns of 4
    std::vector<float> v, r, z, p, q;
    std::vector<std::uint8_t> is_locked;

    void scatter(const Packet& packet, const Turned& turned, float dt) {
        const Wide scale = dt * (packet.beta_s + dt);
        alignas(32) float lanes[90][width];
        for (std::size_t b = 0; b < 10; ++b) {
            for (std::size_t i = 0; i < 9; ++i) {
                const Wide value = scale * turned.stiffness[b][i];
                std::memcpy(lanes[9 * b + i], &value, sizeof value);
            }
        }
        for (std::size_t l = 0; l < static_cast<std::size_t>(packet.count); ++l) {
            for (std::size_t b = 0; b < 10; ++b) {
                const auto [i, j] = pairs[b];
                float k[9];
                for (std::size_t e = 0; e < 9; ++e) k[e] = lanes[9 * b + e][l];
                float* there = &blocks[9 * std::size_t{packet.slots[l][4 * j + i]}];  // column-major of its transpose
                for (std::size_t e = 0; e < 9; ++e) there[e] += k[e];
                if (i == j) continue;
                float* here = &blocks[9 * std::size_t{packet.slots[l][4 * i + j]}];
                for (std::size_t c = 0; c < 3; ++c) {
                    for (std::size_t a = 0; a < 3; ++a) here[3 * c + a] += k[3 * a + c];
                }
            }
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t k = 0; k < 3; ++k)
                    r[4 * std::size_t{packet.node[i][l]} + k] += dt * turned.force[i][k][l];
            }
        }
    }

    void start(const Motion& from, float dt, float gravity_y) {
        const float alpha_dt = static_cast<float>(bundle.materials[0].alpha_per_s) * dt;
        std::fill(blocks.begin(), blocks.end(), 0.0f);
        std::fill(r.begin(), r.end(), 0.0f);
        for (std::size_t i = 0; i < bundle.mass.size(); ++i) {
            const float mass = bundle.mass[i];
            for (std::size_t k = 0; k < 3; ++k) {
                v[4 * i + k] = is_locked[i] ? 0 : from.velocities[4 * i + k];
                r[4 * i + k] = mass * v[4 * i + k];
                blocks[9 * std::size_t{bundle.diagonal[i]} + 4 * k] = mass * (1 + alpha_dt);
            }
            r[4 * i + 1] += mass * dt * gravity_y;
        }
    }

    void invert_diagonals() {
        for (std::size_t i = 0; i < bundle.mass.size(); ++i) {
            const float* k = &blocks[9 * std::size_t{bundle.diagonal[i]}];
            const float a = k[4] * k[8] - k[5] * k[5], b = k[2] * k[5] - k[1] * k[8], c = k[1] * k[5] - k[2] * k[4];
            const float s = 1 / (k[0] * a + k[1] * b + k[2] * c);
            const float d = (k[0] * k[8] - k[2] * k[2]) * s, e = (k[1] * k[2] - k[0] * k[5]) * s;
            const float f = (k[0] * k[4] - k[1] * k[1]) * s;
            const float columns[12] = {a * s, b * s, c * s, 0, b * s, d, e, 0, c * s, e, f, 0};
            std::memcpy(&inverse[12 * i], columns, sizeof columns);
        }
    }

    // q = A of; its product with `of`.
    double multiply(const std::vector<float>& of) {
        double total = 0;
        for (std::size_t row = 0; row < bundle.mass.size(); ++row) {
            Quad sum[3] = {};
            if (!is_locked[row]) {
                for (Index k = bundle.row_start[row]; k < bundle.row_start[row + 1]; ++k) {
                    const float* block = &blocks[9 * std::size_t{k}];
                    const float* x = &of[4 * std::size_t{bundle.column[k]}];
                    for (std::size_t c = 0; c < 3; ++c) sum[c] += load(block + 3 * c) * x[c];
                }
            }
            Quad y = sum[0] + sum[1] + sum[2];
            y[3] = 0;
            store(&q[4 * row], y);
            const Quad product = y * load(&of[4 * row]);
            total += static_cast<double>(product[0] + product[1] + product[2]);
        }
        return total;
    }

    double precondition() {
        double total = 0;
        for (std::size_t i = 0; i < bundle.mass.size(); ++i) {
            const float* columns = &inverse[12 * i];
            const float* x = &r[4 * i];
            const Quad y = load(columns) * x[0] + load(columns + 4) * x[1] + load(columns + 8) * x[2];
            store(&z[4 * i], y);
            const Quad product = y * load(x);
            total += static_cast<double>(product[0] + product[1] + product[2]);
        }
        return total;
    }

    void solve() {
        (void)multiply(v);
        for (std::size_t i = 0; i < r.size(); ++i) r[i] = is_locked[i / 4] ? 0 : r[i] - q[i];
        double rz = precondition();
        p = z;
        for (int iteration = 0; iteration < iterations; ++iteration) {
            const auto a = static_cast<float>(rz / multiply(p));
            for (std::size_t i = 0; i < v.size(); ++i) {
                v[i] += a * p[i];
                r[i] -= a * q[i];
            }
            const double next = precondition();
            const auto b = static_cast<float>(next / rz);
            for (std::size_t i = 0; i < p.size(); ++i) p[i] = z[i] + b * p[i];
            rz = next;
        }
    }
};

Conventional::Conventional(const Bundle& b, int iterations)
    : data_(new Data{b, iterations, {}, {}, {}, {}, {}, {}, {}, {}, {}}) {
    Data& d = *data_;
    d.packets.resize((b.solver_tet_count + width - 1) / width);
    for (std::size_t t = 0; t < d.packets.size() * width; ++t) {
        fill_lane(d.packets[t / width], t % width, b, std::min<std::size_t>(t, b.solver_tet_count - 1));
        if (t < b.solver_tet_count) d.packets[t / width].count = static_cast<int>(t % width) + 1;
    }
    d.blocks.resize(9 * b.column.size() + 4);
    d.inverse.resize(12 * b.mass.size());
    for (auto* vector : {&d.v, &d.r, &d.z, &d.p, &d.q}) vector->resize(4 * b.mass.size());
    d.is_locked = b.locked;
}

Conventional::~Conventional() = default;

std::span<const float> Conventional::step(const Motion& from, float dt, float gravity_y) {
    data_->start(from, dt, gravity_y);
    for (const Packet& packet : data_->packets) data_->scatter(packet, turn(packet, from.positions.data()), dt);
    data_->invert_diagonals();
    data_->solve();
    return data_->v;
}

}
