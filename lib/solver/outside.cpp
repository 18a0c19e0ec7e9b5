// SPDX-License-Identifier: MIT
#include "solver/outside.h"

#include <algorithm>

namespace crumple::solver {
namespace {

// Corners of the faces opposite to corners 0..3, counter-clockwise from outside in a positive tet.
constexpr std::size_t face_corners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

struct Face {
    Index node[3];
    float mass;
};

Face face_of(const Model& model, std::size_t tet, std::size_t corner) {
    Face face{};
    for (std::size_t i = 0; i < 3; ++i) {
        face.node[i] = model.bundle.tets[tet][face_corners[corner][i]];
        face.mass += model.bundle.mass[face.node[i]];
    }
    return face;
}

Vec3f wind_force(const State& state, const Face& face, const Wind& wind, float dt) {
    const Vec3f a = position(state, face.node[0]);
    const Vec3f normal = cross(position(state, face.node[1]) - a, position(state, face.node[2]) - a) * 0.5f;
    const float area = length(normal);
    if (!(area > 0)) return {};
    Vec3f v;
    for (const Index node : face.node) v += velocity(state, node) * (1.0f / 3);
    const Vec3f n = normal / area;
    const float against = dot(wind.velocity - v, n);
    if (!(against < 0)) return {};  // in the lee
    const float push = 0.5f * wind.density_kg_m3 * wind.drag * area * against * against;
    return n * -std::min(push, face.mass * -against / dt);
}

}

Six outside_push(const Model& model, const State& state, const StepInput& input, const WindPush& wind) {
    Six push = wind.push;
    if (!is_pushed(input)) return push;
    for (std::size_t node = 0; node < model.node_count; ++node) {
        const Vec3 force = widen(outside_force(model, state, input, node));
        add_to(push, static_cast<double>(input.dt), push_at(widen(position(state, node)), force));
    }
    return push;
}

WindPush add_wind(const Model& model, const State& state, Workspace& w, const Wind& wind, float dt) {
    WindPush total;
    for (std::size_t tet = 0; tet < model.tet_count; ++tet) {
        const unsigned boundary = model.packets[tet / packet_size].boundary[tet % packet_size];
        for (std::size_t corner = 0; boundary >> corner != 0; ++corner) {
            if (!(boundary >> corner & 1u)) continue;
            const Face face = face_of(model, tet, corner);
            const Vec3f third = wind_force(state, face, wind, dt) * (dt / 3);
            for (const Index node : face.node) {
                for (int i = 0; i < 3; ++i) w.outside[4 * std::size_t{node} + static_cast<std::size_t>(i)] += third[i];
                const double mass = model.bundle.mass[node];
                const Vec3 impulse = widen(third);
                if (mass > 0) total.work += dot(impulse, widen(velocity(state, node)) + impulse * (0.5 / mass));
                add_to(total.push, 1, push_at(widen(position(state, node)), impulse));
            }
        }
    }
    return total;
}

}
