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
        const Index* number = job.edge_blocks + 2 * edge;
        sum.template store<is_uniform>(job.ratio, job.blocks + 9 * static_cast<std::size_t>(number[0]),
                                       job.blocks + 9 * static_cast<std::size_t>(number[1]));
    }
}

// K_ij = lambda S + mu S^T + mu tr(S) I with S = sum over the edge's tets of V R g_i (R g_j)^T.
inline void assemble_edges(const EdgeJob& job, std::size_t begin, std::size_t end) {
    job.is_uniform ? sum_edges<true>(job, begin, end) : sum_edges<false>(job, begin, end);
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
