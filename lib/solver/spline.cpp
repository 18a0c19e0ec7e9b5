// SPDX-License-Identifier: MIT
#include "solver/spline.h"

#include <algorithm>
#include <cmath>

namespace crumple::solver {
namespace {

Vec3f rise(std::span<const float> t, std::span<const Vec3f> p, std::size_t i) {
    return (p[i + 1] - p[i]) / (t[i + 1] - t[i]);
}

// Slope at the middle of three points of their parabola; at the ends the slope that leaves no bend there.
void catmull_rom_slopes(std::span<const float> t, std::span<const Vec3f> p, std::span<Vec3f> m) {
    const std::size_t last = t.size() - 1;
    for (std::size_t i = 1; i < last; ++i) {
        const float before = t[i] - t[i - 1];
        const float after = t[i + 1] - t[i];
        m[i] = (rise(t, p, i - 1) * after + rise(t, p, i) * before) / (before + after);
    }
    m[0] = (rise(t, p, 0) * 3.0f - (last > 1 ? m[1] : rise(t, p, 0))) * 0.5f;
    m[last] = (rise(t, p, last - 1) * 3.0f - (last > 1 ? m[last - 1] : rise(t, p, last - 1))) * 0.5f;
}

// Continuous second derivatives: with h_i the spans and s_i their rises,
//   m_(i-1) / h_(i-1) + 2 (1/h_(i-1) + 1/h_i) m_i + m_(i+1) / h_i = 3 (s_(i-1) / h_(i-1) + s_i / h_i),
// and 2 m_0 + m_1 = 3 s_0 at the ends. Tridiagonal, solved down and up.
void natural_slopes(std::span<const float> t, std::span<const Vec3f> p, std::span<Vec3f> m, std::span<float> above) {
    const std::size_t last = t.size() - 1;
    above[0] = 0.5f;
    m[0] = rise(t, p, 0) * 1.5f;
    for (std::size_t i = 1; i <= last; ++i) {
        const bool is_end = i == last;
        const float low = 1 / (t[i] - t[i - 1]);
        const float high = is_end ? 0 : 1 / (t[i + 1] - t[i]);
        Vec3f right = rise(t, p, i - 1) * (3 * low);
        if (!is_end) right += rise(t, p, i) * (3 * high);
        const float pivot = 2 * (low + high) - low * above[i - 1];
        above[i] = high / pivot;
        m[i] = (right - m[i - 1] * low) / pivot;
    }
    for (std::size_t i = last; i > 0; --i) m[i - 1] -= m[i] * above[i - 1];
}

Mat3 turn_by(Vec3f vector) {
    const float angle = length(vector);
    if (!(angle > 0)) return Mat3::identity();
    const Vec3f n = vector * (std::sin(angle / 2) / angle);
    return to_matrix({n.x, n.y, n.z, std::cos(angle / 2)});
}

}

void find_slopes(SplineKind kind, std::span<const float> times, std::span<const Vec3f> values, std::span<Vec3f> slopes,
                 std::span<float> scratch) {
    if (times.size() < 2) {
        std::fill(slopes.begin(), slopes.end(), Vec3f{});
    } else if (kind == SplineKind::catmull_rom) {
        catmull_rom_slopes(times, values, slopes);
    } else {
        natural_slopes(times, values, slopes, scratch);
    }
}

Vec3f value_at(const Spline& s, float time) {
    if (s.times.empty()) return {};
    if (!(time > s.times.front())) return s.values.front();
    if (time >= s.times.back()) return s.values.back();
    const auto after =
        static_cast<std::size_t>(std::upper_bound(s.times.begin(), s.times.end(), time) - s.times.begin());
    const std::size_t i = after - 1;
    const float span = s.times[after] - s.times[i];
    const float u = (time - s.times[i]) / span;
    const float v = 1 - u;
    return s.values[i] * (v * v * (1 + 2 * u)) + s.values[after] * (u * u * (1 + 2 * v)) +
           s.slopes[i] * (span * u * v * v) - s.slopes[after] * (span * u * u * v);
}

std::size_t drive(const Model& model, const State& state, const Handle& handle, float time, float dt,
                  std::span<Constraint> room) {
    const Mat3 turn = turn_by(value_at(handle.turn, time + dt));
    const Vec3f shift = value_at(handle.shift, time + dt);
    std::size_t count = 0;
    for (const Index node : handle.nodes) {
        if (count == room.size()) break;
        if (node >= model.node_count) continue;
        const Vec3f target = handle.pivot + turn * (model.bundle.rest_positions[node] - handle.pivot) + shift;
        room[count++] = {node, ConstraintKind::fixed, (target - position(state, node)) / dt, {}, {}};
    }
    return count;
}

}
