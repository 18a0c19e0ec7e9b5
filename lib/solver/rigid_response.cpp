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

class Constrained {
public:
    Constrained(const State& state, const StepInput& input, const Workspace& w, std::span<const Partial> partials)
        : state_(state), input_(input), w_(w), partials_(partials) {
        for (const Partial& p : partials)
            fastest_ = std::max(fastest_, static_cast<double>(length(constraint_of(p).velocity)));
    }

    // Changes a motion as little as constraints, and contacts where wanted, ask for. `inverse` tells what a push does.
    void meet(const Matrix6& inverse, bool with_contacts, Six& motion) {
        const std::span<float> pushed = w_.precise;  // how hard, a contact
        std::fill_n(pushed.begin(), partials_.size(), 0.0f);
        for (int sweep = 0; sweep < sweeps; ++sweep) {
            double largest = 0;
            for (std::size_t i = 0; i < partials_.size(); ++i) {
                const int count = partials_[i].is_contact ? int{with_contacts} : partials_[i].taken_count;
                for (int which = 0; which < count; ++which)
                    largest = std::max(largest, meet(row_of(partials_[i], which), inverse, pushed[i], motion));
            }
            if (!(largest > 1e-6 * fastest_)) break;
        }
    }

private:
    // How much faster the node is along the row.
    static double meet(const Row& row, const Matrix6& inverse, float& pushed, Six& motion) {
        const Six answer = times(inverse, row.push);
        const double gives = dot6(row.push, answer);
        if (!(gives > 0)) return 0;
        double push = (row.speed - dot6(row.push, motion)) / gives;
        if (row.is_contact) {
            const double last = static_cast<double>(pushed);
            push = std::max(-last, push);
            pushed = static_cast<float>(last + push);
        }
        add_to(motion, push, answer);
        return std::abs(push) * gives;
    }

    [[nodiscard]] const Constraint& constraint_of(const Partial& p) const {
        return input_.constraints[w_.constraint[p.node] - 1];
    }

    [[nodiscard]] Row row_of(const Partial& p, int which) const {
        const Vec3 along = widen(which == 0 ? p.taken : p.also_taken);
        return {push_at(widen(position(state_, p.node)), along), dot(along, widen(constraint_of(p).velocity)),
                p.is_contact};
    }

    const State& state_;
    const StepInput& input_;
    const Workspace& w_;
    std::span<const Partial> partials_;
    double fastest_ = 0;
};

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
    Constrained constrained(state, input, w, partials);
    RigidResponse response;
    response.is_given = true;
    response.motion = times(inverse, momentum);
    const Six before = response.motion;
    constrained.meet(inverse, true, response.motion);
    response.jump = response.motion;
    add_to(response.jump, -1, before);
    const Vec3 centre = rigid_velocity(response.motion, nodes.centre());
    response.slide = {centre.x, centre.y, centre.z, 0, 0, 0};
    // Turning made way for nodes that a translation tears at. Those in contact stop where they are: response_velocity.
    Matrix6 of_slide{};
    for (std::size_t i = 0; i < 3; ++i) of_slide[7 * i] = mass[0] > 0 ? 1 / mass[0] : 0;
    constrained.meet(of_slide, false, response.slide);
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
