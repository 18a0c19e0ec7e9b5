// SPDX-License-Identifier: MIT
// Constraints by projection: the solve stays symmetric and positive definite on what they leave free
// [Baraff, Witkin 1998, "Large steps in cloth simulation"; Ascher, Boxerman 2003, "On the modified conjugate gradient
// method in cloth simulation"].
#pragma once
#include "solver/step.h"

namespace crumple::solver {

struct ConstraintCounts {
    std::size_t fixed = 0;
    std::size_t partial = 0;
    bool has_bad = false;
};

// Enters the step's constraints into is_fixed and constraint.
ConstraintCounts gather_constraints(const Model& model, Workspace& workspace, const StepInput& input);

// The velocity a node starts the solve with: v where it is free, what is prescribed where it is not.
[[nodiscard]] Vec3f constrained_velocity(const Workspace& workspace, const StepInput& input, Index node, Vec3f v);

// The part of v along the directions that are taken.
[[nodiscard]] Vec3f taken_part(const Partial& partial, Vec3f v);

// Takes the constrained directions out of a row of four floats.
void keep_free_part(const Partial& partial, float* row);

// Lists the partly free nodes in Workspace::partials, by node. REQUIRES: the matrix is assembled, for the list takes
// the memory it was assembled from.
void list_partials(const Model& model, Workspace& workspace, const StepInput& input);

// Preconditioners of constrained nodes: 0 where fixed, the inverse on the free directions where partly free.
void constrain_inverse(const Model& model, Workspace& workspace, std::size_t partial_count);
void constrain_inverse(const Model& model, Workspace& workspace, const Partial& partial);

// Row `node` of A change - load: what its constraint has to give, N s.
[[nodiscard]] Vec3f unbalanced(const Model& model, const Workspace& workspace, Index node);

// N s with which a constraint that counts pushes its node. A contact that pulls has let go.
[[nodiscard]] Vec3f constraint_impulse(const Model& model, const Workspace& workspace, const Constraint& constraint);

// What moving constraints do to the body on the way of this step, J.
[[nodiscard]] double constraint_work(const Model& model, const Workspace& workspace, std::size_t partial_count,
                                     const StepInput& input);

// A dv - b of the constrained directions over dt.
void write_reactions(const Model& model, const Workspace& workspace, std::size_t partial_count, const StepInput& input);

}
