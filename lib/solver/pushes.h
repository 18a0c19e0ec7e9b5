// SPDX-License-Identifier: MIT
// What constraints and contacts push with in a step, once the solve has found the change of velocity: their work, their
// impulses and the reactions. They are what the linear step lacks, A change - load, as long as it is not cut short.
#pragma once
#include "solver/constraints.h"
#include "solver/outside.h"
#include "solver/solve.h"

namespace crumple::solver {

struct Ledger {
    double energy = 0;  // kinetic and elastic before the step, J
    Six momentum{};     // before the step
    WindPush wind;
};

class Pushes {
public:
    Pushes(const Model& model, const State& state, Workspace& workspace, const StepInput& input,
           std::span<Partial> partials, const Ledger& ledger, const Whole& whole);

    [[nodiscard]] bool has_contacts() const { return contact_count_ > 0 && !has_let_go_; }  // that have not given way
    // Contacts give way for the rest of this step: what touches moves as the body does.
    void let_go_of_contacts();

    // J on the way of this step. A free body whose step `is_cut` short lacks more than anything gave: here and in the
    // reactions it is held to the momentum that it took.
    [[nodiscard]] double work(bool is_cut) const;
    // Of constraints, forces and wind, N s and N m s about the origin.
    [[nodiscard]] Six given() const;
    void write_reactions(bool is_cut) const;

private:
    [[nodiscard]] const Constraint& constraint_of(const Partial& p) const {
        return input_.constraints[w_.constraint[p.node] - 1];
    }
    [[nodiscard]] Six taken_by_free_body() const;
    void add_constraint_impulses(Six& given) const;
    // Of what the constraints of a free body lack the part that it took, and what of its momentum that leaves to each
    // contact, N s.
    struct Taken {
        double part = 1;
        Vec3 rest;
    };
    [[nodiscard]] Taken taken_by_constraints() const;

    const Model& model_;
    const State& state_;
    Workspace& w_;
    const StepInput& input_;
    std::span<Partial> partials_;
    const Ledger& ledger_;
    const Whole& whole_;
    double contact_count_ = 0;
    bool has_let_go_ = false;
};

}
