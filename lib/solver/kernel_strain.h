// SPDX-License-Identifier: MIT
// Strain of the tets and its plastic flow, as many at a time as there are lanes (equations 4.7 and 4.8 of the design).
// Included once per instruction set, with CRUMPLE_LANES naming its namespace.
#pragma once

namespace crumple::solver::CRUMPLE_LANES {

// Symmetric: xx yy zz xy xz yz.
struct Strain {
    Lanes e[6];
};

inline Strain symmetric_part(const Lanes (&r)[9], const Lanes (&f)[9]) {
    Lanes s[9];
    transposed_times(r, f, s);
    const Lanes half = Lanes::all(0.5f);
    return {{s[0], s[4], s[8], half * (s[1] + s[3]), half * (s[2] + s[6]), half * (s[5] + s[7])}};
}

inline Lanes trace(const Strain& a) { return a.e[0] + a.e[1] + a.e[2]; }

inline Lanes squared(const Strain& a) {
    const Lanes off = fma(a.e[3], a.e[3], fma(a.e[4], a.e[4], a.e[5] * a.e[5]));
    return fma(a.e[0], a.e[0], fma(a.e[1], a.e[1], fma(a.e[2], a.e[2], off + off)));
}

// sym(R^T F) - I - plastic strain
inline Strain elastic_strain(const Lanes (&r)[9], const Lanes (&f)[9], const TetState& state, int lane) {
    Strain e = symmetric_part(r, f);
    for (int i = 0; i < 3; ++i) e.e[i] = e.e[i] - Lanes::all(1);
    for (int i = 0; i < 6; ++i) e.e[i] = e.e[i] - Lanes::load(state.plastic[i] + lane);
    return e;
}

inline Strain deviator(Strain e) {
    const Lanes mean = trace(e) * Lanes::all(1.0f / 3);
    for (int i = 0; i < 3; ++i) e.e[i] = e.e[i] - mean;
    return e;
}

// What a tet answers with in this step.
struct Moduli {
    Lanes stiffness;  // V mu
    Lanes ratio;      // lambda / mu
};

// A secant is never flatter than this part of the elastic stiffness, for float.
inline constexpr float least_secant = 1e-3f;

// What additive flow does to plastic strain and yield.
struct AdditiveFlow {
    Strain plastic;   // eps_p + c (1 - y / |d|) d, |eps_p| <= max, c = flowing_part()
    Lanes hardening;  // rise of the yield strain
};

// [Mueller, Gross 2004, with flowing_part() in place of dt creep.] Of the lanes that yield.
inline AdditiveFlow flowed(const ElementJob& job, const TetPacket& packet, const TetState& state, int lane,
                           const Strain& d, Lanes size, Mask yields) {
    float fraction_row[16] = {}, hardening_row[16] = {}, limit_row[16] = {};
    for (int l = 0; l < Lanes::width; ++l) {
        const StepMaterial& material = job.materials[packet.material[lane + l]];
        fraction_row[l] = material.flow;
        hardening_row[l] = material.hardening_pa;
        limit_row[l] = material.max_plastic_strain;
    }
    const Lanes yield = Lanes::load(packet.yield_strain + lane) + Lanes::load(state.hardening + lane);
    // The rise of the yield strain per unit of plastic strain; the flow stops where the risen yield meets the strain.
    const Lanes rise = Lanes::all(0.40824829f) * Lanes::load(hardening_row) * Lanes::load(packet.volume + lane) /
                       max(Lanes::load(packet.stiffness + lane), Lanes::all(1e-30f));
    const Lanes amount = Lanes::load(fraction_row) * (size - yield) / (Lanes::all(1) + rise);
    const Lanes factor = select(yields, amount / size, Lanes::all(0));
    AdditiveFlow result;
    for (int i = 0; i < 6; ++i) {
        result.plastic.e[i] = fma(factor, d.e[i], Lanes::load(state.plastic[i] + lane));
    }
    const Lanes limit = Lanes::load(limit_row);
    const Lanes plastic_size = root(squared(result.plastic));
    const Mask is_full = plastic_size > limit;
    const Lanes clamp = select(is_full, limit / plastic_size, Lanes::all(1));
    for (int i = 0; i < 6; ++i) {
        result.plastic.e[i] = select(yields, result.plastic.e[i] * clamp, Lanes::load(state.plastic[i] + lane));
    }
    result.hardening = fma(rise, select(yields & !is_full, amount, Lanes::all(0)), Lanes::load(state.hardening + lane));
    return result;
}

// The lanes that yield, by the size of the deviator. A strain beyond any limit is on its way to overflow; its direction
// is noise.
inline Mask yielding(const TetPacket& packet, const TetState& state, int lane, Lanes size, Mask is_bad) {
    const Lanes yield = Lanes::load(packet.yield_strain + lane) + Lanes::load(state.hardening + lane);
    return (size > yield) & (size <= Lanes::all(1e9f)) & !is_bad;
}

inline void flow_additive(const ElementJob& job, const TetPacket& packet, TetState& state, int lane, Strain& e,
                          const Strain& d, Lanes size, Mask yields) {
    const AdditiveFlow now = flowed(job, packet, state, lane, d, size, yields);
    for (int i = 0; i < 6; ++i) {
        e.e[i] = e.e[i] - (now.plastic.e[i] - Lanes::load(state.plastic[i] + lane));
        now.plastic.e[i].store(state.plastic[i] + lane);
    }
    now.hardening.store(state.hardening + lane);
}

// What flow leaves of the deviatoric stress, as a part of it.
inline Lanes left_by_additive(const ElementJob& job, const TetPacket& packet, const TetState& state, int lane,
                              const Strain& d, Lanes size, Mask yields) {
    const AdditiveFlow then = flowed(job, packet, state, lane, d, size, yields);
    Lanes gone = Lanes::all(0);  // (eps_p afterwards - before) : d
    for (int i = 0; i < 6; ++i) {
        const Lanes part = (then.plastic.e[i] - Lanes::load(state.plastic[i] + lane)) * d.e[i];
        gone = gone + (i < 3 ? part : part + part);
    }
    return Lanes::all(1) - gone / (size * size);
}

inline Lanes left_by_multiplicative(const ElementJob& job, const TetPacket& packet, const TetState& state,
                                    const TetShape& shape, int lane, const Strain& ahead, unsigned yields) {
    float rows[6][16] = {};
    float left[16] = {};
    for (int i = 0; i < 6; ++i) ahead.e[i].store(rows[i]);
    for (int l = 0; l < Lanes::width; ++l) {
        if (yields >> l & 1u) left[l] = left_of_lane(job, packet, state, shape, lane + l, rows, l);
    }
    return Lanes::load(left);
}

// A tet that will yield in this step pushes back with what is left after the flow, its damping included: by the secant
// to the strain it is heading for, which keeps the step linear and its matrix positive definite [Kachanov's iteration,
// once: Ladyzhenskaya; Zeidler 1990, vol. II/B, section 25.14]. Volume keeps its stiffness. Without it the stress of a
// step grows with the strain of a step, and dents with the rate of steps.
inline Moduli secant(const ElementJob& job, const TetPacket& packet, const TetState& state, const TetShape* shape,
                     int lane, const Strain& ahead, Mask is_bad, unsigned& softened) {
    const Moduli whole{Lanes::load(packet.stiffness + lane), Lanes::load(packet.ratio + lane)};
    softened = 0;
    if (job.settings.plasticity == Plasticity::off) return whole;
    const Strain d = deviator(ahead);
    const Lanes size = root(squared(d));
    const Mask yields = yielding(packet, state, lane, size, is_bad);
    softened = bits(yields);
    if (softened == 0) return whole;
    const Lanes left = shape ? left_by_multiplicative(job, packet, state, *shape, lane, ahead, softened)
                             : left_by_additive(job, packet, state, lane, d, size, yields);
    const Lanes one = Lanes::all(1);
    const Lanes s = select(yields, max(Lanes::all(least_secant), left), one);
    return {whole.stiffness * s, fma(Lanes::all(2.0f / 3), one - s, whole.ratio) / s};
}

// What additive flow leaves of the elastic strain at the begin of the next step.
inline Strain strain_left(const ElementJob& job, const TetPacket& packet, const TetState& state, int lane, Strain e,
                          Mask is_bad) {
    if (job.settings.plasticity != Plasticity::additive) return e;
    const Strain d = deviator(e);
    const Lanes size = root(squared(d));
    const Mask yields = yielding(packet, state, lane, size, is_bad);
    if (bits(yields) == 0) return e;
    const AdditiveFlow then = flowed(job, packet, state, lane, d, size, yields);
    for (int i = 0; i < 6; ++i) {
        e.e[i] = e.e[i] - (then.plastic.e[i] - Lanes::load(state.plastic[i] + lane));
    }
    return e;
}

inline void flow_multiplicative(const ElementJob& job, const TetPacket& packet, TetState& state, TetShape& shape,
                                int lane, const Lanes (&f)[9], unsigned yields) {
    float rows[9][16] = {};
    for (int i = 0; i < 9; ++i) f[i].store(rows[i]);
    for (int l = 0; l < Lanes::width; ++l) {
        if (yields >> l & 1u) flow_lane(job, packet, state, shape, lane + l, rows, l);
    }
}

}
