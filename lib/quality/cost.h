// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh costs to simulate, found by trying rather than guessed from shapes.
#pragma once
#include <cstdint>
#include <span>

#include "core/context.h"
#include "core/fields.h"
#include "core/index.h"
#include "core/vec3.h"

namespace crumple::quality {

// Of the unlocked mesh at rest, made of one material with Poisson's ratio 0.3. All 0 without tets, or when one has no
// volume or is turned inside out: such a mesh cannot be simulated at all.
struct Cost {
    double critical_step_m = 0;
    double dt_ratio = 0;
    std::uint32_t pcg_soft = 0;
    std::uint32_t pcg_stiff = 0;
};

template <class Visitor, FieldsOf<Cost> C>
void describe(Visitor& visit, C& c) {
    visit.field("critical_step_m", c.critical_step_m,
                "largest stable explicit step of the whole mesh times the speed of sound, metres (Lanczos)");
    visit.field("dt_ratio", c.dt_ratio, "that step over a regular tet's of the mean volume, 1 is ideal");
    visit.field("pcg_soft", c.pcg_soft,
                "iterations of Jacobi-preconditioned conjugate gradients to 1e-4 for an implicit step in which sound "
                "travels 0.2 box diagonals; 5000: not converged");
    visit.field("pcg_stiff", c.pcg_stiff, "the same for 2 box diagonals");
}

// The right-hand sides of the implicit steps are noise (its seeds are fixed); of three counts the middle one is told,
// as a single one jumps where convergence has a plateau; of counts beyond 1000 the first.
[[nodiscard]] Cost measure_cost(std::span<const Vec3> positions, std::span<const Tet> tets,
                                const Context& context = {});

}
