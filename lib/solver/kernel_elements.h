// SPDX-License-Identifier: MIT
// Rotation, strain, plastic flow, force and world gradients of the tets, as many at a time as there are lanes
// (equations 4.1, 4.6 to 4.8 of the design; R is frozen while the step is solved).
// Included once per instruction set, with CRUMPLE_LANES naming its namespace.
#pragma once

namespace crumple::solver::CRUMPLE_LANES {

struct Edges {
    Lanes x[3], y[3], z[3];  // corner k + 1 minus corner 0
};

inline Edges gather_edges(const float* nodes, const TetPacket& packet, int lane) {
    Lanes x0, y0, z0;
    gather3(nodes, packet.node[0] + lane, x0, y0, z0);
    Edges d;
    for (int k = 0; k < 3; ++k) {
        gather3(nodes, packet.node[k + 1] + lane, d.x[k], d.y[k], d.z[k]);
        d.x[k] = d.x[k] - x0;
        d.y[k] = d.y[k] - y0;
        d.z[k] = d.z[k] - z0;
    }
    return d;
}

inline void load_gradients(const float (*gradient)[16], int lane, Lanes (&g)[9]) {
    for (int i = 0; i < 9; ++i) g[i] = Lanes::load(gradient[i] + lane);
}

// F = Ds Dm^-1
inline void deformation(const Edges& d, const Lanes (&g)[9], Lanes (&f)[9]) {
    for (int j = 0; j < 3; ++j) {
        f[j] = dot3(d.x[0], d.x[1], d.x[2], g[j], g[3 + j], g[6 + j]);
        f[3 + j] = dot3(d.y[0], d.y[1], d.y[2], g[j], g[3 + j], g[6 + j]);
        f[6 + j] = dot3(d.z[0], d.z[1], d.z[2], g[j], g[3 + j], g[6 + j]);
    }
}

// Fills in how newly degenerate lanes collapsed and forgets it where det F is back above the threshold.
inline void update_collapse(const ElementJob& job, const TetPacket& packet, TetState& state, int lane,
                            unsigned is_bad) {
    std::uint8_t* const collapse = state.collapse + lane;
    // Nearly always nobody is bad, or whoever is was so before.
    if (is_bad == nonzero_bytes(collapse)) return;
    for (int l = 0; l < Lanes::width; ++l) {
        if (!(is_bad >> l & 1u)) {
            collapse[l] = 0;
        } else if (collapse[l] == 0) {
            collapse[l] = collapse_of_lane(job, packet, lane + l);
        }
    }
}

struct Treated {
    Lanes f[9];    // what the rotation is taken of
    Mask is_lost;  // the axis of collapse vanished: the last rotation stays
};

// Reflection, projection and the smooth blend of both as one rank-one change of F: F + scale u h^T, with u the axis
// scaled by its area and h the gradient of the moving corners, or F - 2 u (u^T F) / u.u.
inline Treated treat(const ElementJob& job, const TetPacket& packet, const TetState& state, int lane, const Edges& d,
                     const Lanes (&g)[9], const Lanes (&f)[9], Lanes det, Mask is_bad) {
    const Lanes zero = Lanes::all(0);
    Lanes u[3] = {zero, zero, zero};
    Lanes h[3] = {zero, zero, zero};
    Lanes edge_size = zero;
    for (int k = 0; k < 3; ++k) {
        const Lanes sign = look_up(collapse_signs[k], state.collapse + lane);
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        u[0] = fma(sign, fnma(d.z[a], d.y[b], d.y[a] * d.z[b]), u[0]);
        u[1] = fma(sign, fnma(d.x[a], d.z[b], d.z[a] * d.x[b]), u[1]);
        u[2] = fma(sign, fnma(d.y[a], d.x[b], d.x[a] * d.y[b]), u[2]);
        for (int i = 0; i < 3; ++i) h[i] = fma(sign, g[3 * k + i], h[i]);
        edge_size = edge_size + dot3(d.x[k], d.y[k], d.z[k], d.x[k], d.y[k], d.z[k]);
    }
    const Lanes uu = dot3(u[0], u[1], u[2], u[0], u[1], u[2]);
    Treated result;
    result.is_lost = is_bad & !(uu > Lanes::all(1e-10f) * edge_size * edge_size);
    const Lanes alpha = Lanes::all(job.settings.degenerate_threshold);
    const Lanes over = Lanes::all(1) / max(uu, Lanes::all(1e-37f));
    Lanes row[3];
    if (job.settings.treatment == Treatment::reflect) {
        const Lanes scale = select(is_bad & (zero > det), Lanes::all(-2) * over, zero);
        for (int j = 0; j < 3; ++j) row[j] = scale * dot3(u[0], u[1], u[2], f[j], f[3 + j], f[6 + j]);
    } else {
        // In units of the height at which det F is the threshold: 1 - s lifts to it, and below 0 the smooth blend goes
        // on to the mirror image.
        const Lanes s = det / alpha;
        const Lanes t = Lanes::all(1) - s;
        Lanes lift = t;
        if (job.settings.treatment == Treatment::smooth) {
            lift = select(s > zero, (Lanes::all(2) - t) * t * t, t - s);
        }
        const Lanes scale =
            select(is_bad, Lanes::all(6) * Lanes::load(packet.volume + lane) * alpha * lift * over, zero);
        for (int j = 0; j < 3; ++j) row[j] = scale * h[j];
    }
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) result.f[3 * i + j] = fma(u[i], row[j], f[3 * i + j]);
    }
    return result;
}

inline Rotor rotation_by_function(RotationFunction function, const Lanes (&f)[9], const Rotor& last) {
    float rows[9][16] = {};
    float rotor[4][16] = {};
    for (int i = 0; i < 9; ++i) f[i].store(rows[i]);
    store_rotor(last, rotor, 0);
    for (int l = 0; l < Lanes::width; ++l) rotate_lane(function, rows, rotor, l);
    return load_rotor(rotor, 0);
}

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

// A secant is never flatter than this part of the elastic stiffness, for float.
inline constexpr float least_secant = 1e-3f;

// What a tet answers with in this step.
struct Moduli {
    Lanes stiffness;  // V mu
    Lanes ratio;      // lambda / mu
};

// What additive flow does to plastic strain and yield.
struct AdditiveFlow {
    Strain plastic;   // eps_p + c (1 - y / |d|) d, |eps_p| <= max
    Lanes hardening;  // rise of the yield strain
};

// [Mueller, Gross 2004, with the exact exponential in place of dt creep.] Of the lanes that yield.
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

// A tet that will yield in this step pushes back with what is left after the flow, its damping included: by the secant
// to the strain it is heading for, which keeps the step linear and its matrix positive definite [Kachanov's iteration,
// once: Ladyzhenskaya; Zeidler 1990, vol. II/B, section 25.14]. Volume keeps its stiffness. Without it the stress of a
// step grows with the strain of a step, and dents with the rate of steps.
inline Moduli secant(const ElementJob& job, const TetPacket& packet, const TetState& state, int lane,
                     const Strain& ahead, Mask is_bad, unsigned& softened) {
    const Moduli whole{Lanes::load(packet.stiffness + lane), Lanes::load(packet.ratio + lane)};
    softened = 0;
    if (job.settings.plasticity != Plasticity::additive) return whole;
    const Strain d = deviator(ahead);
    const Lanes size = root(squared(d));
    const Mask yields = yielding(packet, state, lane, size, is_bad);
    softened = bits(yields);
    if (softened == 0) return whole;
    const AdditiveFlow then = flowed(job, packet, state, lane, d, size, yields);
    Lanes gone = Lanes::all(0);  // (eps_p afterwards - before) : d
    for (int i = 0; i < 6; ++i) {
        const Lanes part = (then.plastic.e[i] - Lanes::load(state.plastic[i] + lane)) * d.e[i];
        gone = gone + (i < 3 ? part : part + part);
    }
    const Lanes one = Lanes::all(1);
    const Lanes left = max(Lanes::all(least_secant), one - gone / (size * size));
    const Lanes s = select(yields, left, one);
    return {whole.stiffness * s, fma(Lanes::all(2.0f / 3), one - s, whole.ratio) / s};
}

inline void flow_multiplicative(const ElementJob& job, const TetPacket& packet, TetState& state, TetShape& shape,
                                int lane, const Lanes (&f)[9], unsigned yields) {
    float rows[9][16] = {};
    for (int i = 0; i < 9; ++i) f[i].store(rows[i]);
    for (int l = 0; l < Lanes::width; ++l) {
        if (yields >> l & 1u) flow_lane(job, packet, state, shape, lane + l, rows, l);
    }
}

// Writes sqrt(V mu (beta dt + dt^2)) R g of the four corners, and lambda / mu.
inline void write_gradients(const TetPacket& packet, const Moduli& moduli, int lane, float dt, const Lanes (&r)[9],
                            const Lanes (&g)[9], float* out) {
    const Lanes step = Lanes::all(dt);
    const Lanes scale = root(moduli.stiffness * step * (Lanes::load(packet.beta_s + lane) + step));
    const Lanes ratio = moduli.ratio;
    const Lanes zero = Lanes::all(0);
    Lanes sum[3] = {zero, zero, zero};
    for (int k = 0; k < 3; ++k) {
        Lanes m[3];
        for (int i = 0; i < 3; ++i) {
            m[i] = scale * dot3(r[3 * i], r[3 * i + 1], r[3 * i + 2], g[3 * k], g[3 * k + 1], g[3 * k + 2]);
            sum[i] = sum[i] + m[i];
        }
        scatter4(out + 4 * (k + 1), 16, m[0], m[1], m[2], ratio);
    }
    scatter4(out, 16, zero - sum[0], zero - sum[1], zero - sum[2], ratio);
}

// f = -dt V R (lambda tr(eps) I + 2 mu eps) g of the four corners.
inline void write_forces(const Moduli& moduli, float dt, const Lanes (&r)[9], const Lanes (&g)[9], const Strain& e,
                         float* out) {
    const Lanes scale = moduli.stiffness * Lanes::all(-dt);
    const Lanes two = scale + scale;
    const Lanes pressure = scale * moduli.ratio * trace(e);
    const Lanes xx = fma(two, e.e[0], pressure), yy = fma(two, e.e[1], pressure), zz = fma(two, e.e[2], pressure);
    const Lanes xy = two * e.e[3], xz = two * e.e[4], yz = two * e.e[5];
    const Lanes zero = Lanes::all(0);
    Lanes sum[3] = {zero, zero, zero};
    for (int k = 0; k < 3; ++k) {
        const Lanes tx = dot3(xx, xy, xz, g[3 * k], g[3 * k + 1], g[3 * k + 2]);
        const Lanes ty = dot3(xy, yy, yz, g[3 * k], g[3 * k + 1], g[3 * k + 2]);
        const Lanes tz = dot3(xz, yz, zz, g[3 * k], g[3 * k + 1], g[3 * k + 2]);
        Lanes t[3];
        for (int i = 0; i < 3; ++i) {
            t[i] = dot3(r[3 * i], r[3 * i + 1], r[3 * i + 2], tx, ty, tz);
            sum[i] = sum[i] + t[i];
        }
        scatter4(out + 4 * (k + 1), 16, t[0], t[1], t[2], zero);
    }
    scatter4(out, 16, zero - sum[0], zero - sum[1], zero - sum[2], zero);
}

inline Rotor rotation_of(const ElementJob& job, const TetPacket& packet, TetState& state, int lane, const Edges& d,
                         const Lanes (&g)[9], const Lanes (&f)[9], Lanes det, Mask is_bad) {
    const Rotor last = load_rotor(state.rotation, lane);
    const auto rotate = [&](const Lanes(&of)[9]) {
        return job.settings.rotation ? rotation_by_function(job.settings.rotation, of, last)
                                     : nearest_rotation(of, last);
    };
    if (bits(is_bad) == 0 || job.settings.treatment == Treatment::off) return rotate(f);
    const Treated treated = treat(job, packet, state, lane, d, g, f, det, is_bad);
    return select(treated.is_lost, last, rotate(treated.f));
}

// Plastic flow of the lanes that yield; leaves e the elastic strain afterwards and says who flowed.
inline unsigned flow(const ElementJob& job, const TetPacket& packet, TetState& state, TetShape* shape, int lane,
                     const Edges& d, const Lanes (&r)[9], Lanes (&g)[9], Lanes (&f)[9], Mask is_bad, Strain& e) {
    if (job.settings.plasticity == Plasticity::off) return 0;
    const Strain dev = deviator(e);
    const Lanes size = root(squared(dev));
    const Mask yields = yielding(packet, state, lane, size, is_bad);
    if (bits(yields) == 0) return 0;
    if (shape == nullptr) {
        flow_additive(job, packet, state, lane, e, dev, size, yields);
    } else {
        flow_multiplicative(job, packet, state, *shape, lane, f, bits(yields));
        load_gradients(shape->gradient, lane, g);
        deformation(d, g, f);
        e = elastic_strain(r, f, state, lane);
    }
    return bits(yields);
}

// mu |eps|^2 + lambda/2 tr(eps)^2, times the volume.
inline Lanes strain_energy(const TetPacket& packet, int lane, const Strain& e) {
    const Lanes tr = trace(e);
    const Lanes half_ratio = Lanes::all(0.5f) * Lanes::load(packet.ratio + lane);
    return Lanes::load(packet.stiffness + lane) * fma(half_ratio * tr, tr, squared(e));
}

inline double total(Lanes a) {
    float lanes[16] = {};
    a.store(lanes);
    double sum = 0;
    for (int l = 0; l < Lanes::width; ++l) sum += static_cast<double>(lanes[l]);
    return sum;
}

inline ElementCounts step_lanes(const ElementJob& job, std::size_t p, int lane, Lanes& energy) {
    const TetPacket& packet = job.packets[p];
    TetState& state = job.states[p];
    TetShape* shape = job.shapes ? job.shapes + p : nullptr;
    Lanes g[9], f[9], r[9];
    load_gradients(shape ? shape->gradient : packet.gradient, lane, g);
    const Edges d = gather_edges(job.positions, packet, lane);
    deformation(d, g, f);
    const Lanes det = determinant(f);
    const Mask is_bad = !(det > Lanes::all(job.settings.degenerate_threshold));
    update_collapse(job, packet, state, lane, bits(is_bad));
    const Rotor q = rotation_of(job, packet, state, lane, d, g, f, det, is_bad);
    store_rotor(q, state.rotation, lane);
    to_matrix(q, r);

    Strain e = elastic_strain(r, f, state, lane);
    const unsigned yields = flow(job, packet, state, shape, lane, d, r, g, f, is_bad, e);
    energy = energy + strain_energy(packet, lane, e);
    // The strain where the solve linearizes: at x + (beta + dt) v with R as it is.
    Lanes rate[9];
    deformation(gather_edges(job.velocities, packet, lane), g, rate);
    const Strain strain_rate = symmetric_part(r, rate);
    const Lanes ahead = Lanes::load(packet.beta_s + lane) + Lanes::all(job.settings.dt);
    for (int i = 0; i < 6; ++i) e.e[i] = fma(ahead, strain_rate.e[i], e.e[i]);

    const std::size_t first = 16 * (packet_size * p + static_cast<std::size_t>(lane));
    unsigned softened = 0;
    const Moduli moduli = secant(job, packet, state, lane, e, is_bad, softened);
    write_gradients(packet, moduli, lane, job.settings.dt, r, g, job.gradients + first);
    write_forces(moduli, job.settings.dt, r, g, e, job.forces + first);
    const Mask is_real = Lanes::load(packet.stiffness + lane) > Lanes::all(0);  // not padding
    return {static_cast<std::uint32_t>(__builtin_popcount(bits(is_bad & is_real))),
            static_cast<std::uint32_t>(__builtin_popcount(yields)),
            static_cast<std::uint32_t>(__builtin_popcount(softened)), 0};
}

inline ElementCounts step_elements(const ElementJob& job, std::size_t begin, std::size_t end) {
    ElementCounts counts;
    Lanes energy = Lanes::all(0);
    for (std::size_t p = begin; p < end; ++p) {
        for (int lane = 0; lane < static_cast<int>(packet_size); lane += Lanes::width) {
            const ElementCounts some = step_lanes(job, p, lane, energy);
            counts.degenerate += some.degenerate;
            counts.yielding += some.yielding;
            counts.softened += some.softened;
        }
    }
    counts.energy = total(energy);
    return counts;
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

// The elastic energy a step from the job's positions would start with. Leaves the rotations there.
inline double elastic_energies(const ElementJob& job, std::size_t begin, std::size_t end) {
    Lanes energy = Lanes::all(0);
    for (std::size_t p = begin; p < end; ++p) {
        const TetPacket& packet = job.packets[p];
        TetState state = job.states[p];  // a copy: how tets collapse on a way that may not be taken is not kept
        for (int lane = 0; lane < static_cast<int>(packet_size); lane += Lanes::width) {
            Lanes g[9], f[9], r[9];
            load_gradients(job.shapes ? job.shapes[p].gradient : packet.gradient, lane, g);
            const Edges d = gather_edges(job.positions, packet, lane);
            deformation(d, g, f);
            const Lanes det = determinant(f);
            const Mask is_bad = !(det > Lanes::all(job.settings.degenerate_threshold));
            update_collapse(job, packet, state, lane, bits(is_bad));
            const Rotor q = rotation_of(job, packet, state, lane, d, g, f, det, is_bad);
            // What a degenerate tet does depends on its last rotation: that of a way not taken must not stay.
            store_rotor(select(is_bad, load_rotor(state.rotation, lane), q), job.states[p].rotation, lane);
            to_matrix(q, r);
            energy = energy +
                     strain_energy(packet, lane,
                                   strain_left(job, packet, state, lane, elastic_strain(r, f, state, lane), is_bad));
        }
    }
    return total(energy);
}

inline void extract_rotations(RotationPacket* packets, std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
        for (int lane = 0; lane < static_cast<int>(packet_size); lane += Lanes::width) {
            Lanes f[9];
            load_gradients(packets[p].f, lane, f);
            const Rotor q = nearest_rotation(f, load_rotor(packets[p].rotation, lane));
            store_rotor(q, packets[p].rotation, lane);
        }
    }
}

}
