// SPDX-License-Identifier: MIT
// The matrix, eight rows at a time: finishing it, and its product with vectors. See slices.h for how it lies. Included
// once per instruction set, with CRUMPLE_LANES naming its namespace.
#pragma once
#include "bundle/too_light.h"

namespace crumple::solver::CRUMPLE_LANES {

// Inverses of symmetric positive blocks by their cofactors; 0 where one is not positive.
inline void invert_blocks(const Eight (&k)[9], Eight (&inverse)[9]) {
    const Eight a = fnma(k[5], k[5], k[4] * k[8]);
    const Eight b = fnma(k[1], k[8], k[2] * k[5]);
    const Eight c = fnma(k[2], k[4], k[1] * k[5]);
    const Eight det = fma(k[0], a, fma(k[1], b, k[2] * c));
    const Eight zero = Eight::all(0);
    const Eight s = select(det > zero, Eight::all(1) / det, zero);
    inverse[0] = a * s;
    inverse[1] = inverse[3] = b * s;
    inverse[2] = inverse[6] = c * s;
    inverse[4] = fnma(k[2], k[2], k[0] * k[8]) * s;
    inverse[5] = inverse[7] = fnma(k[0], k[5], k[1] * k[2]) * s;
    inverse[8] = fnma(k[1], k[1], k[0] * k[4]) * s;
}

// Rows of K sum to zero, so the diagonal is the damped mass minus the rest of the row. Where the mass would drown
// (bundle/too_light.h), it is raised until it does not: the node answers more slowly, the solve stays sound.
// Returns how many nodes that were.
inline std::uint32_t finish_diagonals(const RowJob& job, std::size_t slice, const Eight (&rest)[9]) {
    const Index* const node = job.node + slice_rows * slice;
    Eight k[9], inverse[9];
    for (std::size_t i = 0; i < 9; ++i) k[i] = Eight::all(0) - rest[i];
    float masses[slice_rows];
    for (std::size_t l = 0; l < slice_rows; ++l) masses[l] = job.damped_mass[node[l]];
    const Eight mass = Eight::load(masses);
    const Eight lacking = fnma(Eight::all(light_share), mass, Eight::all(resolved_by_float / 3) * (k[0] + k[4] + k[8]));
    const auto is_light = lacking > Eight::all(0);
    const Eight raised = select(is_light, mass + lacking, mass);
    for (const std::size_t i : {0, 4, 8}) k[i] = k[i] + raised;
    float* const diagonal = job.blocks + group_floats * job.start[slice];
    for (std::size_t i = 0; i < 9; ++i) k[i].store(diagonal + slice_rows * i);
    invert_blocks(k, inverse);
    for (std::size_t c = 0; c < 3; ++c) {
        scatter4([&](std::size_t l) { return job.inverse + inverse_at(node[l]) + 16 * c; }, inverse[3 * c],
                 inverse[3 * c + 1], inverse[3 * c + 2], Eight::all(0));
    }
    return static_cast<std::uint32_t>(__builtin_popcount(bits(is_light)));
}

// Blocks that only fill up their row. They come last, so the groups before one without any have none.
inline void clear_fillers(const RowJob& job, std::size_t slice) {
    const Index* const first = job.column + slice_rows * job.start[slice];
    for (std::size_t group = job.start[slice + 1] - std::size_t{1}; group > job.start[slice]; --group) {
        bool is_any = false;
        for (std::size_t l = 0; l < slice_rows; ++l) {
            if (job.column[slice_rows * group + l] != first[l]) continue;
            is_any = true;
            for (std::size_t i = 0; i < 9; ++i) job.blocks[group_floats * group + 9 * l + i] = 0;
        }
        if (!is_any) return;
    }
}

// Blocks come whole, one after the other within their group, and go element by element.
inline std::uint32_t finish_rows(const RowJob& job, std::size_t begin, std::size_t end) {
    std::uint32_t raised = 0;
    for (std::size_t slice = begin / slice_rows; slice * slice_rows < end; ++slice) {
        clear_fillers(job, slice);
        Eight sum[9];
        for (Eight& element : sum) element = Eight::all(0);
        for (std::size_t group = job.start[slice] + std::size_t{1}; group < job.start[slice + 1]; ++group) {
            float* const at = job.blocks + group_floats * group;
            Eight block[9];
            gather_blocks(at, block);
            for (std::size_t i = 0; i < 9; ++i) {
                sum[i] = sum[i] + block[i];
                block[i].store(at + slice_rows * i);
            }
        }
        raised += finish_diagonals(job, slice, sum);
    }
    return raised;
}

inline bool is_all_fixed(const std::uint8_t* is_fixed, const Index* node) {
    std::size_t l = 0;
    while (l < slice_rows && is_fixed[node[l]]) ++l;
    return l == slice_rows;
}

// Rows without freedom are left out where they fill a slice; elsewhere nobody asks what they hold.
inline void multiply(const SolveJob& job, std::size_t begin, std::size_t end) {
    // What is read through `job` in the loop would be read again after every store.
    const float* const direction = job.direction;
    float* const product = job.product;
    const Index* const start = job.start;
    for (std::size_t slice = begin / slice_rows; slice * slice_rows < end; ++slice) {
        const Index* const node = job.node + slice_rows * slice;
        // A sum for each element, or every addition would wait for the one before.
        Eight sum[9];
        for (Eight& element : sum) element = Eight::all(0);
        const std::size_t last = is_all_fixed(job.is_fixed, node) ? start[slice] : start[slice + 1];
        for (std::size_t group = start[slice]; group < last; ++group) {
            const float* const block = job.blocks + group_floats * group;
            Eight x[3];
            gather3(direction, job.column + slice_rows * group, x[0], x[1], x[2]);
            for (std::size_t i = 0; i < 9; ++i) sum[i] = fma(Eight::load(block + slice_rows * i), x[i / 3], sum[i]);
        }
        scatter4([&](std::size_t l) { return product + 4 * static_cast<std::size_t>(node[l]); },
                 sum[0] + sum[3] + sum[6], sum[1] + sum[4] + sum[7], sum[2] + sum[5] + sum[8], Eight::all(0));
    }
}

}
