// SPDX-License-Identifier: MIT
#include "solver/pushes.h"

#include <algorithm>
#include <limits>

namespace crumple::solver {

Pushes::Pushes(const Model& model, const State& state, Workspace& workspace, const StepInput& input,
               std::span<Partial> partials, const Ledger& ledger, const Whole& whole)
    : model_(model), state_(state), w_(workspace), input_(input), partials_(partials), ledger_(ledger), whole_(whole) {
    for (const Partial& p : partials_) contact_count_ += p.is_contact ? 1 : 0;
}

void Pushes::let_go_of_contacts() {
    has_let_go_ = true;
    for (Partial& p : partials_) {
        if (!p.is_contact) continue;
        p.taken_count = 0;
        p.least = std::numeric_limits<float>::lowest();
    }
}

double Pushes::work(bool is_cut) const {
    const double lacking = constraint_work(model_, w_, partials_.size(), input_);
    if (!is_cut || !whole_.response.is_given || partials_.empty()) return lacking;
    const Taken taken = taken_by_constraints();
    double work = lacking * taken.part;
    for (const Partial& p : partials_) work += p.is_contact ? dot(taken.rest, widen(constraint_of(p).velocity)) : 0;
    return work;
}

Six Pushes::given() const {
    Six given = ledger_.wind.push;
    if (!input_.forces.empty()) {
        for (std::size_t node = 0; node < model_.node_count; ++node) {
            add_to(given, static_cast<double>(input_.dt),
                   push_at(widen(position(state_, node)), widen(input_.forces[node])));
        }
    }
    if (!whole_.response.is_given) {
        add_constraint_impulses(given);
    } else if (!partials_.empty()) {
        add_to(given, 1, taken_by_free_body());
    }
    return given;
}

void Pushes::write_reactions(bool is_cut) const {
    solver::write_reactions(model_, w_, partials_.size(), input_);
    if (!is_cut || !whole_.response.is_given || partials_.empty()) return;
    const Taken taken = taken_by_constraints();
    for (const Partial& p : partials_) {
        Vec3 push = p.is_contact ? taken.rest : Vec3{};
        if (p.taken_count > 0) push += widen(constraint_impulse(model_, w_, constraint_of(p))) * taken.part;
        input_.reactions[p.node] = narrow(push / static_cast<double>(input_.dt));
    }
}

// A free body's momentum changes by what its constraints give and by what is known: so the two agree whatever the
// solve left undone.
Six Pushes::taken_by_free_body() const {
    Six taken{};
    add_to(taken, -1, ledger_.momentum);
    const double dt = static_cast<double>(input_.dt);
    for (std::size_t node = 0; node < model_.node_count; ++node) {
        const float* change = &w_.change[4 * node];
        const Vec3 v = widen(velocity(state_, node)) + Vec3{change[0], change[1], change[2]};
        const Vec3 known =
            widen(outside_force(model_, state_, input_, node)) - v * static_cast<double>(model_.alpha_mass[node]);
        const Vec3 gained = v * static_cast<double>(model_.bundle.mass[node]) - known * dt;
        add_to(taken, 1, push_at(widen(position(state_, node)), gained));
    }
    add_to(taken, 1, times(whole_.locks.own_mass, whole_.locks.change));
    add_to(taken, -1, whole_.locks.fall);
    add_to(taken, -1, ledger_.wind.push);
    return taken;
}

// What each constraint gives; a body that some of them hold fast.
void Pushes::add_constraint_impulses(Six& given) const {
    for (Index node = 0; node < model_.node_count; ++node) {
        if (w_.constraint[node] == 0 || model_.bundle.locked[node]) continue;
        const Constraint& c = input_.constraints[w_.constraint[node] - 1];
        if (c.kind == ConstraintKind::contact && has_let_go_) continue;
        add_to(given, 1, push_at(widen(position(state_, node)), widen(constraint_impulse(model_, w_, c))));
    }
}

Pushes::Taken Pushes::taken_by_constraints() const {
    const Vec3 all = linear_part(taken_by_free_body());
    Vec3 lacking;
    for (const Partial& p : partials_) {
        if (p.taken_count > 0) lacking += widen(constraint_impulse(model_, w_, constraint_of(p)));
    }
    const double squared = dot(lacking, lacking);
    Taken taken;
    if (squared > 0) taken.part = std::clamp(dot(all, lacking) / squared, 0.0, 1.0);
    if (contact_count_ > 0) taken.rest = (all - lacking * taken.part) / contact_count_;
    return taken;
}

}
