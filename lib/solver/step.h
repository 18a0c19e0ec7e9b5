// SPDX-License-Identifier: MIT
// One step of corotational linear finite elements, semi-implicit Euler [Brinck 2016, "Math in Games"]:
//
//     (M + C dt + K' dt^2) v+ = M v + dt (f_outside + f_elastic(x)),   x+ = x + dt v+,   C = alpha M + beta K'
//
// with K' the element stiffness turned by the element's rotation R. step() neither allocates nor throws, and gives the
// same bits for any Jobs.
#pragma once
#include <span>

#include "core/fields.h"
#include "solver/jobs.h"
#include "solver/state.h"

namespace crumple::solver {

inline constexpr int version = 1;

struct Settings {
    RotationMethod rotation = RotationMethod::apd;
    Treatment treatment = Treatment::reflect;
    double degenerate_threshold = 0.1;  // of det F
    Plasticity plasticity = Plasticity::additive;
    double min_plastic_stretch = 0.5;  // multiplicative plasticity only
    double max_plastic_stretch = 1.2;
    std::uint32_t max_iterations = 20;
    double tolerance = 0;  // stop when r.Pr <= tolerance^2 b.Pb; 0: run all iterations
    Isa isa = Isa::automatic;
};

template <class Visitor, FieldsOf<Settings> S>
void describe(Visitor& visit, S& s) {
    visit.field("rotation", s.rotation, "how the rotation of a tet is found");
    visit.field("treatment", s.treatment, "what is done to the rotation of inverted tets");
    visit.field("degenerate_threshold", s.degenerate_threshold, Range{1e-3, 0.9},
                "det F below which a tet is degenerate");
    visit.field("plasticity", s.plasticity, "how plastic strain is kept");
    visit.field("min_plastic_stretch", s.min_plastic_stretch, Range{0.01, 1},
                "multiplicative plasticity: least stretch");
    visit.field("max_plastic_stretch", s.max_plastic_stretch, Range{1, 100},
                "multiplicative plasticity: largest stretch");
    visit.field("max_iterations", s.max_iterations, Range{1, 1e6}, "budget of conjugate gradient iterations a step");
    visit.field("tolerance", s.tolerance, Range{0, 1}, "relative residual at which the iterations stop early");
    visit.field("isa", s.isa, "widest instruction set to use");
}

enum class ConstraintKind : std::uint8_t {
    fixed,    // moves with `velocity`
    plane,    // its velocity along `normal` is that of `velocity`, the rest is free
    rail,     // and along `second` too
    contact,  // its velocity along `normal` is at least that of `velocity`: it is pushed, never pulled
};

// Air over the boundary, in the frame of the positions.
struct Wind {
    Vec3f velocity;
    float density_kg_m3 = 1.2f;
    float drag = 1;
};

// For one step. A locked node is fixed at velocity 0 unless a constraint says otherwise; of several for one node the
// last one counts. `normal` and `second` need not be unit or orthogonal, only independent.
struct Constraint {
    Index node = none;
    ConstraintKind kind = ConstraintKind::fixed;
    Vec3f velocity;
    Vec3f normal;
    Vec3f second;
};

struct StepInput {
    float dt = 1.0f / 60;
    Vec3f gravity{0, 0, 0};
    Vec3f frame_turn;       // rad/s: the positions are in a frame that turns like this
    Vec3f frame_turn_rate;  // rad/s^2
    // Locked nodes are one rigid body of this mass, the nodes' own included (less counts as that), that the step may
    // push; velocities are then relative to what it does: StepReport::carrier. None: they stand.
    bool has_free_carrier = false;
    double carrier_mass = 0;
    std::span<const Vec3f> forces;  // N or empty, newtons
    const Wind* wind = nullptr;
    std::span<const Constraint> constraints;
    std::span<Vec3f> reactions;  // N or empty: newtons each node's constraint pushes with, 0 where free
};

// Bits of StepReport::warnings.
enum StepWarning : std::uint32_t {
    step_too_stiff = 1,       // float lost the positive definiteness of A: the solve stopped early
    step_not_finite = 2,      // a velocity, or the load, overflowed and was set to 0
    step_bad_constraint = 4,  // a node out of range or a direction without length: ignored
    step_bad_input = 8,       // dt not positive, a wrong length, a number that is none: nothing was done
    step_restrained = 16,     // cut short, or it would have made energy; contacts may have given way
};

struct StepReport {
    std::uint32_t iterations = 0;
    float residual = 0;            // sqrt(r.Pr / b.Pb) at the end
    std::uint32_t degenerate = 0;  // tets with det F <= threshold at the start of the step
    std::uint32_t yielding = 0;    // tets that flowed plastically
    std::uint32_t warnings = 0;
    double start_energy = 0;  // kinetic and elastic when it began, as it saw them, J
    double energy = 0;        // at the end
    // What forces, wind and the constraints of nodes that are not locked gave, about the origin of the frame. Gravity
    // and inertia are not in it.
    Vec3 impulse;          // N s
    Vec3 angular_impulse;  // N m s
    // By how much a free carrier is faster and turns faster after the step, in the frame, at its origin.
    Vec3 carrier_velocity;
    Vec3 carrier_turn;
};

StepReport step(const Model& model, State& state, Workspace& workspace, const StepInput& input,
                const Settings& settings = {}, const Jobs& jobs = {}) noexcept;

}
