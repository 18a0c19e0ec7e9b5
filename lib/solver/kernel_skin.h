// SPDX-License-Identifier: MIT
// Drawn vertices, one at a time: four floats of a node are one load.
// Included once per instruction set, with CRUMPLE_LANES naming its namespace.
#pragma once

namespace crumple::solver::CRUMPLE_LANES {

// v + 2 q x (q x v + w v)
inline Vec3f turned(const float (&q)[4], float x, float y, float z) {
    const float cx = q[1] * z - q[2] * y + q[3] * x;
    const float cy = q[2] * x - q[0] * z + q[3] * y;
    const float cz = q[0] * y - q[1] * x + q[3] * z;
    return {x + 2 * (q[1] * cz - q[2] * cy), y + 2 * (q[2] * cx - q[0] * cz), z + 2 * (q[0] * cy - q[1] * cx)};
}

inline void skin_vertices(const SkinJob& job, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
        const std::size_t t = job.tet[v];
        float sum[4] = {};
        for (std::size_t i = 0; i < 4; ++i) {
            const float* x = job.positions + 4 * static_cast<std::size_t>(job.tets[t][i]);
            const float weight = job.barycentric[v][i];
            for (std::size_t k = 0; k < 4; ++k) sum[k] += weight * x[k];
        }
        job.drawn_positions[v] = {sum[0], sum[1], sum[2]};
        if (job.drawn_normals == nullptr && job.drawn_tangents == nullptr) continue;
        float q[4] = {0, 0, 0, 1};
        if (t < job.tet_count) {
            const auto& rows = job.states[t / packet_size].rotation;
            for (std::size_t k = 0; k < 4; ++k) q[k] = rows[k][t % packet_size];
        }
        if (job.drawn_normals != nullptr) {
            const Vec3f n = job.normals[v];
            job.drawn_normals[v] = turned(q, n.x, n.y, n.z);
        }
        if (job.drawn_tangents != nullptr) {
            const auto& a = job.tangents[v];
            const Vec3f turned_tangent = turned(q, a[0], a[1], a[2]);
            job.drawn_tangents[v] = {turned_tangent.x, turned_tangent.y, turned_tangent.z, a[3]};
        }
    }
}

}
