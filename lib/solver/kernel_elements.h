// SPDX-License-Identifier: MIT
// One step of the tets, as many at a time as there are lanes: rotation, collapse, force and world gradients (equations
// 4.1 and 4.6 of the design; R is frozen while the step is solved).
// Included once per instruction set, with CRUMPLE_LANES naming its namespace.
#pragma once
#include <cstring>

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
inline void update_collapse(const ElementJob& job, const TetPacket& packet, std::uint8_t* collapse, int lane,
                            unsigned is_bad) {
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
inline Treated treat(const ElementJob& job, const TetPacket& packet, const std::uint8_t* collapse, int lane,
                     const Edges& d, const Lanes (&g)[9], const Lanes (&f)[9], Lanes det, Mask is_bad) {
    const Lanes zero = Lanes::all(0);
    Lanes u[3] = {zero, zero, zero};
    Lanes h[3] = {zero, zero, zero};
    Lanes edge_size = zero;
    for (int k = 0; k < 3; ++k) {
        const Lanes sign = look_up(collapse_signs[k], collapse);
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

inline Rotor rotation_of(const ElementJob& job, const TetPacket& packet, const Rotor& last,
                         const std::uint8_t* collapse, int lane, const Edges& d, const Lanes (&g)[9],
                         const Lanes (&f)[9], Lanes det, Mask is_bad) {
    const auto rotate = [&](const Lanes(&of)[9]) {
        return job.settings.rotation ? rotation_by_function(job.settings.rotation, of, last)
                                     : nearest_rotation(of, last);
    };
    if (bits(is_bad) == 0 || job.settings.treatment == Treatment::off) return rotate(f);
    const Treated treated = treat(job, packet, collapse, lane, d, g, f, det, is_bad);
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
    update_collapse(job, packet, state.collapse + lane, lane, bits(is_bad));
    const Rotor last = load_rotor(state.rotation, lane);
    const Rotor q = rotation_of(job, packet, last, state.collapse + lane, lane, d, g, f, det, is_bad);
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
    const Moduli moduli = secant(job, packet, state, shape, lane, e, is_bad, softened);
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

// The elastic energy a step from the job's positions would start with. Leaves the rotations there.
inline double elastic_energies(const ElementJob& job, std::size_t begin, std::size_t end) {
    Lanes energy = Lanes::all(0);
    for (std::size_t p = begin; p < end; ++p) {
        const TetPacket& packet = job.packets[p];
        TetState& state = job.states[p];
        // A copy: how tets collapse on a way that may not be taken is not kept.
        std::uint8_t collapse[packet_size];
        std::memcpy(collapse, state.collapse, sizeof collapse);
        for (int lane = 0; lane < static_cast<int>(packet_size); lane += Lanes::width) {
            Lanes g[9], f[9], r[9];
            load_gradients(job.shapes ? job.shapes[p].gradient : packet.gradient, lane, g);
            const Edges d = gather_edges(job.positions, packet, lane);
            deformation(d, g, f);
            const Lanes det = determinant(f);
            const Mask is_bad = !(det > Lanes::all(job.settings.degenerate_threshold));
            update_collapse(job, packet, collapse + lane, lane, bits(is_bad));
            const Rotor last = load_rotor(state.rotation, lane);
            const Rotor q = rotation_of(job, packet, last, collapse + lane, lane, d, g, f, det, is_bad);
            // What a degenerate tet does depends on its last rotation: that of a way not taken must not stay.
            store_rotor(select(is_bad, last, q), state.rotation, lane);
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
