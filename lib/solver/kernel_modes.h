// SPDX-License-Identifier: MIT
// The loops of the rigid motions (see rigid_modes.h). Rows of eight floats so that a compiler finds their vectors.
// Included once per instruction set, with CRUMPLE_LANES naming its namespace.
#pragma once

namespace crumple::solver::CRUMPLE_LANES {

// A Z of bodies without constraints, Z = [I, -[x]].
inline void multiply_modes(const ModeJob& job, std::size_t begin, std::size_t end) {
    const Eight zero = Eight::all(0);
    for (std::size_t slice = begin / slice_rows; slice * slice_rows < end; ++slice) {
        Eight moved[9], turned[9];
        for (std::size_t i = 0; i < 9; ++i) moved[i] = turned[i] = zero;
        for (std::size_t group = job.start[slice]; group < job.start[slice + 1]; ++group) {
            Eight x, y, z, b[9];
            gather3(job.positions, job.column + slice_rows * group, x, y, z);
            for (std::size_t i = 0; i < 9; ++i) {
                b[i] = Eight::load(job.blocks + group_floats * group + slice_rows * i);
                moved[i] = moved[i] + b[i];
            }
            for (std::size_t axis = 0; axis < 3; ++axis) {
                turned[axis] = fma(y, b[6 + axis], fnma(z, b[3 + axis], turned[axis]));
                turned[3 + axis] = fma(z, b[axis], fnma(x, b[6 + axis], turned[3 + axis]));
                turned[6 + axis] = fma(x, b[3 + axis], fnma(y, b[axis], turned[6 + axis]));
            }
        }
        const Index* const node = job.node + slice_rows * slice;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto row = [&](std::size_t l) { return job.rows + mode_floats * node[l] + 8 * axis; };
            scatter4(row, moved[axis], moved[3 + axis], moved[6 + axis], turned[axis]);
            scatter4([&](std::size_t l) { return row(l) + 4; }, turned[3 + axis], turned[6 + axis], zero, zero);
        }
    }
}

inline void dot_modes(const ModeJob& job, std::size_t begin, std::size_t end, float* sums) {
    float sum[8] = {};
    for (std::size_t node = begin; node < end; ++node) {
        const float* row = job.rows + mode_floats * node;
        const float* v = job.precise + 4 * node;
        for (std::size_t m = 0; m < 8; ++m) sum[m] += row[m] * v[0] + row[8 + m] * v[1] + row[16 + m] * v[2];
    }
    for (std::size_t m = 0; m < 8; ++m) sums[m] = sum[m];
}

inline void mode_energies(const ModeJob& job, std::size_t begin, std::size_t end, float* sums) {
    Eight sum[6];
    for (Eight& row : sum) row = Eight::all(0);
    for (std::size_t node = begin; node < end; ++node) {
        const float* const row = job.rows + mode_floats * node;
        const Eight ax = Eight::load(row), ay = Eight::load(row + 8), az = Eight::load(row + 16);
        const Eight x = Eight::all(job.positions[4 * node]);
        const Eight y = Eight::all(job.positions[4 * node + 1]);
        const Eight z = Eight::all(job.positions[4 * node + 2]);
        sum[0] = sum[0] + ax;
        sum[1] = sum[1] + ay;
        sum[2] = sum[2] + az;
        sum[3] = fma(y, az, fnma(z, ay, sum[3]));
        sum[4] = fma(z, ax, fnma(x, az, sum[4]));
        sum[5] = fma(x, ay, fnma(y, ax, sum[5]));
    }
    for (std::size_t r = 0; r < 6; ++r) sum[r].store(sums + 8 * r);
}

inline void subtract_motion(const ModeJob& job, const RigidField& field, std::size_t begin, std::size_t end) {
    const Quads fixed = Quads::load(field.constant);
    const Quads by_x = Quads::load(field.by_x);
    const Quads by_y = Quads::load(field.by_y);
    const Quads by_z = Quads::load(field.by_z);
    for (std::size_t node = begin; node < end; node += Quads::nodes) {
        const Quads x = Quads::load(job.positions + 4 * node);
        const Quads p = Quads::load(job.direction + 4 * node) + fixed;
        fma(by_x, spread<0>(x), fma(by_y, spread<1>(x), fma(by_z, spread<2>(x), p))).store(job.direction + 4 * node);
    }
}

}
