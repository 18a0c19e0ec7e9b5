// SPDX-License-Identifier: MIT
#include "solver/element_lane.h"

#include <algorithm>
#include <cmath>

#include "solver/degenerate.h"

namespace crumple::solver {
namespace {

Mat3 lane_matrix(const float (*rows)[packet_size], int l) {
    Mat3 a;
    for (std::size_t i = 0; i < 9; ++i) a.m[i] = rows[i][l];
    return a;
}

Vec3f node_vector(const float* nodes, Index node) {
    const float* p = nodes + 4 * static_cast<std::size_t>(node);
    return {p[0], p[1], p[2]};
}

// U diag(d) V^T
Mat3 compose(const Mat3& u, Vec3f d, const Mat3& v) {
    Mat3 scaled = u;
    for (int c = 0; c < 3; ++c) scaled.set_column(c, u.column(c) * d[c]);
    return scaled * transpose(v);
}

// Stretches without their common factor, so that plastic flow keeps the volume.
Vec3f without_volume(Vec3f s) { return s / std::cbrt(s.x * s.y * s.z); }

// Logarithms shrunk together until each stretch is allowed: their sum stays zero, the volume stays.
Vec3f clamped_stretches(Vec3f s, float low, float high) {
    float shrink = 1;
    for (int i = 0; i < 3; ++i) {
        const float log_s = std::log(s[i]);
        if (s[i] > high) shrink = std::min(shrink, std::log(high) / log_s);
        if (s[i] < low) shrink = std::min(shrink, std::log(low) / log_s);
    }
    if (shrink == 1) return s;
    return {std::pow(s.x, shrink), std::pow(s.y, shrink), std::pow(s.z, shrink)};
}

Mat3 inverse(const Mat3& a) { return transpose(cofactor(a)) * (1 / determinant(a)); }

// What multiplicative flow makes of a shape.
struct Flowed {
    bool is_any = false;
    Mat3 gradient;
    float hardening = 0;
};

// F = F_e F_p, F_e = U S V^T: F_p <- V S^gamma V^T F_p with the part of the excess that flows as gamma
// [Irving, Teran, Fedkiw 2004, section 5]; the elastic part keeps U S^(1 - gamma) V^T, so R stays.
Flowed flowed(const ElementJob& job, const TetPacket& packet, const TetState& state, const TetShape& shape, int lane,
              const Mat3& elastic) {
    const Svd svd = singular_values(elastic);
    if (!(svd.s.z > 1e-3f * svd.s.x)) return {};
    const StepMaterial& material = job.materials[packet.material[lane]];
    const Vec3f mean = Vec3f{1, 1, 1} * ((svd.s.x + svd.s.y + svd.s.z) / 3);
    const float size = length(svd.s - mean);
    const float yield = packet.yield_strain[lane] + state.hardening[lane];
    const float gamma = material.flow * std::max(0.0f, 1 - yield / size);
    const Vec3f s = without_volume(svd.s);
    const Vec3f undone{std::pow(s.x, -gamma), std::pow(s.y, -gamma), std::pow(s.z, -gamma)};

    const Mat3 rest = lane_matrix(packet.gradient, lane);
    const Mat3 shaped = lane_matrix(shape.gradient, lane) * compose(svd.v, undone, svd.v);
    // shaped = Dm^-1 F_p^-1; keep the stretches of F_p in bounds.
    const Svd undo = singular_values(inverse(rest) * shaped);
    if (!(undo.s.z > 0)) return {};
    const Vec3f limited = clamped_stretches(without_volume(undo.s), 1 / job.settings.max_plastic_stretch,
                                            1 / job.settings.min_plastic_stretch);
    const Mat3 result = rest * compose(undo.u, limited, undo.v);
    if (!std::isfinite(norm(result))) return {};
    const float rise = 0.40824829f * material.hardening_pa * packet.volume[lane] / packet.stiffness[lane];
    return {true, result, rise * gamma * size};
}

Mat3 deviator(const Mat3& a) {
    const Mat3 symmetric = (a + transpose(a)) * 0.5f;
    return symmetric - Mat3::identity() * (trace(symmetric) / 3);
}

}

std::uint8_t collapse_of_lane(const ElementJob& job, const TetPacket& packet, int lane) {
    CollapsePath path;
    for (std::size_t i = 0; i < 4; ++i) {
        path.to[i] = node_vector(job.positions, packet.node[i][lane]);
        path.from[i] = path.to[i] - node_vector(job.velocities, packet.node[i][lane]) * job.settings.last_dt;
    }
    path.six_rest_volumes = 6 * packet.volume[lane];
    path.threshold = job.settings.degenerate_threshold;
    return static_cast<std::uint8_t>(classify_collapse(path));
}

void rotate_lane(RotationFunction function, const float (*f)[packet_size], float (*rotor)[packet_size], int l) {
    const Quaternion last{rotor[0][l], rotor[1][l], rotor[2][l], rotor[3][l]};
    const Quaternion q = to_quaternion(function(lane_matrix(f, l), to_matrix(last)));
    if (!std::isfinite(q.x + q.y + q.z + q.w)) return;
    rotor[0][l] = q.x;
    rotor[1][l] = q.y;
    rotor[2][l] = q.z;
    rotor[3][l] = q.w;
}

void flow_lane(const ElementJob& job, const TetPacket& packet, TetState& state, TetShape& shape, int lane,
               const float (*f)[packet_size], int l) {
    const Flowed now = flowed(job, packet, state, shape, lane, lane_matrix(f, l));
    if (!now.is_any) return;
    for (std::size_t i = 0; i < 9; ++i) shape.gradient[i][lane] = now.gradient.m[i];
    state.hardening[lane] += now.hardening;
}

float left_of_lane(const ElementJob& job, const TetPacket& packet, const TetState& state, const TetShape& shape,
                   int lane, const float (*strain)[packet_size], int l) {
    constexpr std::size_t row[9] = {0, 3, 4, 3, 1, 5, 4, 5, 2};
    Mat3 s = Mat3::identity();
    for (std::size_t i = 0; i < 9; ++i) s.m[i] += strain[row[i]][l];
    const Flowed then = flowed(job, packet, state, shape, lane, s);
    if (!then.is_any) return 1;
    const Mat3 before = deviator(s);
    const Mat3 after = deviator(s * inverse(lane_matrix(shape.gradient, lane)) * then.gradient);
    float along = 0;
    for (std::size_t i = 0; i < 9; ++i) along += after.m[i] * before.m[i];
    const float left = along / (norm(before) * norm(before));
    return left >= 0 ? std::min(left, 1.0f) : 0;
}

}
