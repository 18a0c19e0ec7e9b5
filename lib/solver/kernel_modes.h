// SPDX-License-Identifier: MIT
// The loops of the rigid motions (see rigid_modes.h). Rows of eight floats so that a compiler finds their vectors.
// Included once per instruction set, with CRUMPLE_LANES naming its namespace.
#pragma once

namespace crumple::solver::CRUMPLE_LANES {

// Moments of the blocks of a row: sums of A, A x, A y, A z.
inline void row_moments(const ModeJob& job, std::size_t row, float (&sum)[4][9]) {
    BlockSum plain, by_x, by_y, by_z;
    for (std::size_t k = job.row_start[row]; k < job.row_start[row + 1]; ++k) {
        const float* block = job.blocks + 9 * k;
        const float* x = job.positions + 4 * static_cast<std::size_t>(job.column[k]);
        plain.add(block);
        by_x.add(block, x[0]);
        by_y.add(block, x[1]);
        by_z.add(block, x[2]);
    }
    plain.store(sum[0]);
    by_x.store(sum[1]);
    by_y.store(sum[2]);
    by_z.store(sum[3]);
}

// A Z of bodies without constraints: Z is [I, -[x]], columns of blocks are contiguous.
inline void multiply_modes(const ModeJob& job, std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
        float sum[4][9] = {};
        row_moments(job, row, sum);
        float* out = job.rows + mode_floats * row;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float* lanes = out + 8 * axis;
            for (std::size_t c = 0; c < 3; ++c) lanes[c] = sum[0][3 * c + axis];
            lanes[3] = sum[2][6 + axis] - sum[3][3 + axis];  // y c2 - z c1
            lanes[4] = sum[3][axis] - sum[1][6 + axis];      // z c0 - x c2
            lanes[5] = sum[1][3 + axis] - sum[2][axis];      // x c1 - y c0
            lanes[6] = lanes[7] = 0;
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
