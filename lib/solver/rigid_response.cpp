// SPDX-License-Identifier: MIT
#include "solver/rigid_response.h"

#include <algorithm>
#include <cmath>

#include "solver/constraints.h"

namespace crumple::solver {
namespace {

constexpr int sweeps = 50;
constexpr double small_angle = 0.1;  // rad: nodes that go straight end 0.5 % too far out

// One direction in which a node is not free.
struct Row {
    Six push;
    double speed;  // along it
    bool is_contact;
};

Row row_of(const State& state, const StepInput& input, const Workspace& w, const Partial& p, int which) {
    const Vec3 along = widen(which == 0 ? p.taken : p.also_taken);
    const Constraint& c = input.constraints[w.constraint[p.node] - 1];
    return {push_at(widen(position(state, p.node)), along), dot(along, widen(c.velocity)), p.is_contact};
}

}

RigidResponse respond_rigidly(const Model& model, const State& state, const StepInput& input, Workspace& w,
                              std::span<const Partial> partials, const RigidLocks& locks, const Six& momentum) {
    PointMasses nodes;
    for (std::size_t node = 0; node < model.node_count; ++node) {
        nodes.add(static_cast<double>(model.bundle.mass[node]), widen(position(state, node)));
    }
    Matrix6 mass = nodes.matrix();
    for (std::size_t i = 0; i < 36; ++i) mass[i] += locks.own_mass[i];
    const Matrix6 inverse = inverse_of(mass, 1e-12);
    RigidResponse response;
    response.is_given = true;
    response.motion = times(inverse, momentum);
    const Six before = response.motion;
    double fastest = 0;
    for (const Partial& p : partials)
        fastest = std::max(fastest, static_cast<double>(length(input.constraints[w.constraint[p.node] - 1].velocity)));
    const std::span<float> pushed = w.precise;  // how hard, a contact
    std::fill_n(pushed.begin(), partials.size(), 0.0f);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        double largest = 0;
        for (std::size_t i = 0; i < partials.size(); ++i) {
            const int count = partials[i].is_contact ? 1 : partials[i].taken_count;
            for (int which = 0; which < count; ++which) {
                const Row row = row_of(state, input, w, partials[i], which);
                const Six answer = times(inverse, row.push);
                const double gives = dot6(row.push, answer);
                if (!(gives > 0)) continue;
                double push = (row.speed - dot6(row.push, response.motion)) / gives;
                if (row.is_contact) {
                    const double last = static_cast<double>(pushed[i]);
                    push = std::max(-last, push);
                    pushed[i] = static_cast<float>(last + push);
                }
                add_to(response.motion, push, answer);
                largest = std::max(largest, std::abs(push) * gives);
            }
        }
        if (!(largest > 1e-6 * fastest)) break;
    }
    response.jump = response.motion;
    add_to(response.jump, -1, before);
    const Vec3 centre = rigid_velocity(response.motion, nodes.centre());
    response.slide = {centre.x, centre.y, centre.z, 0, 0, 0};
    const double angle = length(angular_part(response.motion)) * static_cast<double>(input.dt);
    response.haven = angle < small_angle ? response.motion : response.slide;
    return response;
}

Vec3 response_velocity(const Six& motion, const Partial& p, Vec3 x, Vec3 v) {
    const Vec3 u = rigid_velocity(motion, x);
    if (p.is_contact) {
        const Vec3 n = widen(p.taken);
        return u + n * std::max(0.0, static_cast<double>(p.least) - dot(n, u));
    }
    // What is prescribed is met already.
    return u + widen(taken_part(p, narrow(v - u)));
}

}
