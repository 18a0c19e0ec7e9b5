// SPDX-License-Identifier: MIT
// Tets in packets of sixteen, each field a row of sixteen, so that any vector width loads its lanes at once.
#pragma once
#include <cstdint>

#include "core/fields.h"
#include "core/index.h"
#include "solver/rotation.h"

namespace crumple::solver {

inline constexpr std::size_t packet_size = 16;

// What never changes. Padding tets repeat the last one with stiffness 0, so they push nobody.
struct alignas(64) TetPacket {
    float gradient[9][packet_size];   // row 3 k + axis: gradient of the weight of corner k + 1 (Dm^-1 row-major)
    float volume[packet_size];        // V, m^3
    float stiffness[packet_size];     // V mu
    float ratio[packet_size];         // lambda / mu
    float beta_s[packet_size];        // Rayleigh damping
    float yield_strain[packet_size];  // sqrt(2/3) yield / (2 mu): norm of the deviatoric strain at yield
    Index node[4][packet_size];
    std::uint16_t material[packet_size];
    std::uint8_t boundary[packet_size];  // bit c: the face opposite to corner c is outside and not all locked
    std::uint8_t padding[packet_size];
};
static_assert(sizeof(TetPacket) % 64 == 0);

// What is saved with the positions and velocities.
struct alignas(64) TetState {
    float rotation[4][packet_size];      // unit quaternion x, y, z, w
    float plastic[6][packet_size];       // plastic strain xx yy zz xy xz yz, trace-free
    float hardening[packet_size];        // rise of yield_strain
    std::uint8_t collapse[packet_size];  // Collapse of a degenerate tet, 0 of any other
    std::uint8_t padding[3 * packet_size];
};
static_assert(sizeof(TetState) % 64 == 0);

// Multiplicative plasticity: Dm^-1 F_p^-1 in place of Dm^-1.
struct alignas(64) TetShape {
    float gradient[9][packet_size];
};

struct alignas(64) RotationPacket {
    float f[9][packet_size];         // row-major
    float rotation[4][packet_size];  // in: last rotation; out: this one
};

enum class Treatment { reflect, project, smooth, off };
inline constexpr EnumName<Treatment> treatment_names[] = {{Treatment::reflect, "reflect"},
                                                          {Treatment::project, "project"},
                                                          {Treatment::smooth, "smooth"},
                                                          {Treatment::off, "off"}};
constexpr std::span<const EnumName<Treatment>> enum_names(Treatment) { return treatment_names; }

enum class Plasticity { additive, multiplicative, off };
inline constexpr EnumName<Plasticity> plasticity_names[] = {
    {Plasticity::additive, "additive"}, {Plasticity::multiplicative, "multiplicative"}, {Plasticity::off, "off"}};
constexpr std::span<const EnumName<Plasticity>> enum_names(Plasticity) { return plasticity_names; }

// A material's plastic flow during one step.
struct StepMaterial {
    float flow = 0;  // flowing_part()
    float hardening_pa = 0;
    float max_plastic_strain = 0;
};

// The part of the strain beyond yield that flows in a step: implicit Euler's. Where strain goes on at a steady rate,
// rate / creep of it is left whatever dt, and that is the stress that carries a crash. The exponential decay of a
// strain that is held would leave less the longer the step: half as much again was dented at 240 steps a second.
constexpr double flowing_part(double creep_per_s, double dt) { return creep_per_s * dt / (1 + creep_per_s * dt); }

struct ElementSettings {
    float dt = 0;
    float last_dt = 0;  // positions a step ago are x - last_dt v
    float degenerate_threshold = 0.1f;
    Treatment treatment = Treatment::reflect;
    Plasticity plasticity = Plasticity::additive;
    RotationFunction rotation = nullptr;  // null: the wide default
    float min_plastic_stretch = 0.5f;
    float max_plastic_stretch = 1.2f;
};

}
