// SPDX-License-Identifier: MIT
// The numbers of one material, as the solver eats them. Units are in the names; solver.md's plasticity uses them as is.
#pragma once
#include <string>

#include "core/fields.h"

namespace crumple {

struct Material {
    std::string name = "steel";
    double young_pa = 2e8;  // game steel: real steel is 2e11, which no game step resolves
    double poisson = 0.3;
    double density_kg_m3 = 1000;    // of the control volume, sheet metal and air together
    double yield_pa = 2.5e6;        // uniaxial (von Mises) yield stress
    double creep_per_s = 60;        // rate of plastic flow beyond yield
    double hardening_pa = 0;        // yield rises by this per unit of plastic strain
    double max_plastic_strain = 1;  // norm of the plastic strain is clamped here
    double alpha_per_s = 0.15;      // Rayleigh damping, mass part
    double beta_s = 0.004;          // Rayleigh damping, stiffness part
};

template <class Visitor, FieldsOf<Material> M>
void describe(Visitor& visit, M& m) {
    visit.field("name", m.name, "what recipes and reports call it");
    visit.field("young_pa", m.young_pa, Range{1, 1e13}, "Young's modulus");
    visit.field("poisson", m.poisson, Range{0, 0.499}, "Poisson's ratio");
    visit.field("density_kg_m3", m.density_kg_m3, Range{1e-3, 1e6}, "mass per volume of the control mesh");
    visit.field("yield_pa", m.yield_pa, Range{0, 1e13}, "uniaxial stress at which it stays bent");
    visit.field("creep_per_s", m.creep_per_s, Range{0, 1e6}, "rate of plastic flow beyond yield");
    visit.field("hardening_pa", m.hardening_pa, Range{0, 1e13}, "rise of the yield stress per unit of plastic strain");
    visit.field("max_plastic_strain", m.max_plastic_strain, Range{0, 100}, "largest norm of the plastic strain");
    visit.field("alpha_per_s", m.alpha_per_s, Range{0, 1e6}, "Rayleigh damping by mass");
    visit.field("beta_s", m.beta_s, Range{0, 1e3}, "Rayleigh damping by stiffness");
}

// "young_pa is -1, allowed are 1 to 1e+13" for the first field outside its range (a NaN is outside), else empty.
[[nodiscard]] std::string first_field_out_of_range(const Material& material);

}
