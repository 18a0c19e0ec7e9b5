// SPDX-License-Identifier: MIT
// The loops over nodes and edges: gathering loads, assembling blocks, conjugate gradients.
// Included once per instruction set, with CRUMPLE_LANES naming its namespace.
#pragma once

namespace crumple::solver::CRUMPLE_LANES {

inline void gather_loads(const LoadJob& job, std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
        float sum[4];
        for (std::size_t i = 0; i < 4; ++i) sum[i] = job.outside[4 * node + i];
        for (Index k = job.node_start[node]; k < job.node_start[node + 1]; ++k) {
            const float* force = job.forces + 4 * static_cast<std::size_t>(job.node_corner[k]);
            for (std::size_t i = 0; i < 4; ++i) sum[i] += force[i];
        }
        for (std::size_t i = 0; i < 4; ++i) job.load[4 * node + i] = sum[i];
    }
}

template <bool is_uniform>
void sum_edges(const EdgeJob& job, std::size_t begin, std::size_t end) {
    for (std::size_t edge = begin; edge < end; ++edge) {
        OuterSum sum;
        for (Index k = job.edge_start[edge]; k < job.edge_start[edge + 1]; ++k) {
            const Index incidence = job.incidence[k];
            const float* tet = job.gradients + 16 * static_cast<std::size_t>(incidence >> 4);
            sum.template add<is_uniform>(tet + (incidence & 12u), tet + 4 * (incidence & 3u));
        }
        const Index* slot = job.edge_slots + 2 * edge;
        sum.template store<is_uniform>(job.ratio, job.blocks + 9 * static_cast<std::size_t>(slot[0]),
                                       job.blocks + 9 * static_cast<std::size_t>(slot[1]));
    }
}

// K_ij = lambda S + mu S^T + mu tr(S) I with S = sum over the edge's tets of V R g_i (R g_j)^T.
inline void assemble_edges(const EdgeJob& job, std::size_t begin, std::size_t end) {
    job.is_uniform ? sum_edges<true>(job, begin, end) : sum_edges<false>(job, begin, end);
}

// Inverse of a symmetric positive 3 x 3 block by its cofactors.
inline void invert_block(const float* k, float* inverse) {
    const float a = k[4] * k[8] - k[5] * k[5];
    const float b = k[2] * k[5] - k[1] * k[8];
    const float c = k[1] * k[5] - k[2] * k[4];
    const float det = k[0] * a + k[1] * b + k[2] * c;
    const float s = det > 0 ? 1 / det : 0;
    const float d = (k[0] * k[8] - k[2] * k[2]) * s;
    const float e = (k[1] * k[2] - k[0] * k[5]) * s;
    const float f = (k[0] * k[4] - k[1] * k[1]) * s;
    const float columns[3][4] = {{a * s, b * s, c * s, 0}, {b * s, d, e, 0}, {c * s, e, f, 0}};
    for (std::size_t col = 0; col < 3; ++col) {
        for (std::size_t i = 0; i < 4; ++i) inverse[16 * col + i] = columns[col][i];
    }
}

// A diagonal block this small a part of the stiffness is lost in the rounding of its sum, and with it the positive
// definiteness of A.
inline constexpr float resolved_by_float = 3e-7f;

// Rows of K sum to zero, so the diagonal is the damped mass minus the rest of the row. Where the mass would drown, it
// is raised until it does not: the node answers more slowly, the solve stays sound. Returns how many nodes that were.
inline std::uint32_t finish_rows(const RowJob& job, std::size_t begin, std::size_t end) {
    std::uint32_t raised = 0;
    for (std::size_t row = begin; row < end; ++row) {
        const std::size_t diagonal = job.diagonal[row];
        BlockSum below, above;
        for (std::size_t k = job.row_start[row]; k < diagonal; ++k) below.add(job.blocks + 9 * k);
        for (std::size_t k = diagonal + 1; k < job.row_start[row + 1]; ++k) above.add(job.blocks + 9 * k);
        float sums[2][9];
        below.store(sums[0]);
        above.store(sums[1]);
        float* block = job.blocks + 9 * diagonal;
        for (std::size_t i = 0; i < 9; ++i) block[i] = -(sums[0][i] + sums[1][i]);
        const float least = resolved_by_float / 3 * (block[0] + block[4] + block[8]);
        float mass = job.damped_mass[row];
        if (least > mass / 8) {
            mass += least - mass / 8;
            ++raised;
        }
        for (const std::size_t i : {0, 4, 8}) block[i] += mass;
        invert_block(block, job.inverse + inverse_at(row));
    }
    return raised;
}

inline void multiply(const SolveJob& job, std::size_t begin, std::size_t end) {
    // What is read through `job` in the loop would be read again after every store.
    const float* const blocks = job.blocks;
    const float* const direction = job.direction;
    const Index* const column = job.column;
    const auto x = [&](std::size_t k) { return direction + 4 * static_cast<std::size_t>(column[k]); };
    for (std::size_t row = begin; row < end; ++row) {
        RowSum sum;
        if (!job.is_fixed[row]) {
            std::size_t k = job.row_start[row];
            const std::size_t row_end = job.row_start[row + 1];
            for (; k + 1 < row_end; k += 2) sum.add_pair(blocks + 9 * k, x(k), x(k + 1));
            if (k < row_end) sum.add(blocks + 9 * k, x(k));
        }
        sum.store(job.product + 4 * row);
    }
}

inline double dot_nodes(const float* a, const float* b, std::size_t begin, std::size_t end) {
    Quads total = Quads::all(0);
    for (std::size_t node = begin; node < end; node += Quads::nodes) {
        total = fma(Quads::load(a + 4 * node), Quads::load(b + 4 * node), total);
    }
    return static_cast<double>(sum(total));
}

inline double product_dot(const SolveJob& job, std::size_t begin, std::size_t end) {
    return dot_nodes(job.direction, job.product, begin, end);
}

inline Quads precondition(const SolveJob& job, std::size_t node, Quads r) {
    const float* inverse = job.inverse + inverse_at(node);
    return fma(Quads::load(inverse), spread<0>(r),
               fma(Quads::load(inverse + 16), spread<1>(r), Quads::load(inverse + 32) * spread<2>(r)));
}

inline double start(const SolveJob& job, std::size_t begin, std::size_t end) {
    Quads total = Quads::all(0);
    for (std::size_t node = begin; node < end; node += Quads::nodes) {
        const Quads r = Quads::load(job.residual + 4 * node);
        const Quads z = precondition(job, node, r);
        z.store(job.precise + 4 * node);
        z.store(job.direction + 4 * node);
        total = fma(r, z, total);
    }
    return static_cast<double>(sum(total));
}

inline double descend(const SolveJob& job, float a, std::size_t begin, std::size_t end) {
    const Quads forward = Quads::all(a);
    const Quads back = Quads::all(-a);
    Quads total = Quads::all(0);
    for (std::size_t node = begin; node < end; node += Quads::nodes) {
        const std::size_t at = 4 * node;
        fma(forward, Quads::load(job.direction + at), Quads::load(job.change + at)).store(job.change + at);
        const Quads r = fma(back, Quads::load(job.product + at), Quads::load(job.residual + at));
        r.store(job.residual + at);
        const Quads z = precondition(job, node, r);
        z.store(job.precise + at);
        total = fma(r, z, total);
    }
    return static_cast<double>(sum(total));
}

inline void turn(const SolveJob& job, float b, std::size_t begin, std::size_t end) {
    const Quads keep = Quads::all(b);
    for (std::size_t node = begin; node < end; node += Quads::nodes) {
        const std::size_t at = 4 * node;
        fma(keep, Quads::load(job.direction + at), Quads::load(job.precise + at)).store(job.direction + at);
    }
}

}
