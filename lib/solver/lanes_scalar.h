// SPDX-License-Identifier: MIT
// One lane: the kernels as plain scalar code, for tests and for processors without a wide version.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace crumple::solver::scalar {

struct Mask {
    bool m;
    friend Mask operator&(Mask a, Mask b) { return {a.m && b.m}; }
    friend Mask operator|(Mask a, Mask b) { return {a.m || b.m}; }
    friend Mask operator!(Mask a) { return {!a.m}; }
};

struct Lanes {
    float v;
    static constexpr int width = 1;
    static Lanes load(const float* p) { return {*p}; }
    static Lanes all(float x) { return {x}; }
    void store(float* p) const { *p = v; }
    friend Lanes operator+(Lanes a, Lanes b) { return {a.v + b.v}; }
    friend Lanes operator-(Lanes a, Lanes b) { return {a.v - b.v}; }
    friend Lanes operator*(Lanes a, Lanes b) { return {a.v * b.v}; }
    friend Lanes operator/(Lanes a, Lanes b) { return {a.v / b.v}; }
    friend Mask operator>(Lanes a, Lanes b) { return {a.v > b.v}; }
    friend Mask operator<=(Lanes a, Lanes b) { return {a.v <= b.v}; }
};

inline Lanes fma(Lanes a, Lanes b, Lanes c) { return {a.v * b.v + c.v}; }
inline Lanes fnma(Lanes a, Lanes b, Lanes c) { return {c.v - a.v * b.v}; }
inline Lanes root(Lanes a) { return {std::sqrt(a.v)}; }
inline Lanes max(Lanes a, Lanes b) { return {a.v > b.v ? a.v : b.v}; }
inline Lanes min(Lanes a, Lanes b) { return {a.v < b.v ? a.v : b.v}; }
inline Lanes abs(Lanes a) { return {std::fabs(a.v)}; }
inline Lanes select(Mask m, Lanes a, Lanes b) { return m.m ? a : b; }
inline unsigned bits(Mask m) { return m.m ? 1u : 0u; }
inline Mask mask_of(unsigned b) { return {(b & 1u) != 0}; }

// Lane l = table[index[l]].
inline Lanes look_up(const float (&table)[8], const std::uint8_t* index) { return {table[*index]}; }

// Which of as many bytes as there are lanes are not 0.
inline unsigned nonzero_bytes(const std::uint8_t* bytes) { return *bytes != 0 ? 1u : 0u; }

// Lane l of (x, y, z) = the first three floats at base + 4 index[l].
inline void gather3(const float* base, const unsigned* index, Lanes& x, Lanes& y, Lanes& z) {
    const float* p = base + 4 * static_cast<std::size_t>(*index);
    x.v = p[0];
    y.v = p[1];
    z.v = p[2];
}

// Lane l of (x, y, z, w) to the four floats at out + stride l.
inline void scatter4(float* out, std::size_t, Lanes x, Lanes y, Lanes z, Lanes w) {
    out[0] = x.v;
    out[1] = y.v;
    out[2] = z.v;
    out[3] = w.v;
}

// Four floats of each of `nodes` nodes.
struct Quads {
    float v[4];
    static constexpr int nodes = 1;
    static Quads load(const float* p) { return {{p[0], p[1], p[2], p[3]}}; }
    static Quads all(float x) { return {{x, x, x, x}}; }
    void store(float* p) const {
        for (int i = 0; i < 4; ++i) p[i] = v[i];
    }
    friend Quads operator+(Quads a, Quads b) {
        return {{a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2], a.v[3] + b.v[3]}};
    }
    friend Quads operator*(Quads a, Quads b) {
        return {{a.v[0] * b.v[0], a.v[1] * b.v[1], a.v[2] * b.v[2], a.v[3] * b.v[3]}};
    }
};

inline Quads fma(Quads a, Quads b, Quads c) { return a * b + c; }
template <int component>
Quads spread(Quads a) {
    return Quads::all(a.v[component]);
}
inline float sum(Quads a) { return (a.v[0] + a.v[1]) + (a.v[2] + a.v[3]); }

struct EightMask {
    bool m[8];
};

// One float of each row of a slice of the matrix.
struct Eight {
    float v[8];
    static constexpr int width = 8;
    static Eight load(const float* p) {
        Eight a;
        for (std::size_t l = 0; l < 8; ++l) a.v[l] = p[l];
        return a;
    }
    static Eight all(float x) { return {{x, x, x, x, x, x, x, x}}; }
    void store(float* p) const {
        for (std::size_t l = 0; l < 8; ++l) p[l] = v[l];
    }
    friend Eight operator+(Eight a, const Eight& b) {
        for (std::size_t l = 0; l < 8; ++l) a.v[l] += b.v[l];
        return a;
    }
    friend Eight operator-(Eight a, const Eight& b) {
        for (std::size_t l = 0; l < 8; ++l) a.v[l] -= b.v[l];
        return a;
    }
    friend Eight operator*(Eight a, const Eight& b) {
        for (std::size_t l = 0; l < 8; ++l) a.v[l] *= b.v[l];
        return a;
    }
    friend Eight operator/(Eight a, const Eight& b) {
        for (std::size_t l = 0; l < 8; ++l) a.v[l] /= b.v[l];
        return a;
    }
    friend EightMask operator>(const Eight& a, const Eight& b) {
        EightMask mask;
        for (std::size_t l = 0; l < 8; ++l) mask.m[l] = a.v[l] > b.v[l];
        return mask;
    }
};

inline Eight fma(const Eight& a, const Eight& b, const Eight& c) { return a * b + c; }
inline Eight fnma(const Eight& a, const Eight& b, const Eight& c) { return c - a * b; }
inline Eight select(const EightMask& mask, Eight a, const Eight& b) {
    for (std::size_t l = 0; l < 8; ++l) a.v[l] = mask.m[l] ? a.v[l] : b.v[l];
    return a;
}
inline unsigned bits(const EightMask& mask) {
    unsigned all = 0;
    for (std::size_t l = 0; l < 8; ++l) all |= (mask.m[l] ? 1u : 0u) << l;
    return all;
}

inline void gather3(const float* base, const unsigned* index, Eight& x, Eight& y, Eight& z) {
    for (std::size_t l = 0; l < 8; ++l) {
        const float* p = base + 4 * static_cast<std::size_t>(index[l]);
        x.v[l] = p[0];
        y.v[l] = p[1];
        z.v[l] = p[2];
    }
}

// Lane l of (x, y, z, w) to the four floats at place(l), a boundary of 16 bytes.
template <class Place>
void scatter4(const Place& place, const Eight& x, const Eight& y, const Eight& z, const Eight& w) {
    for (std::size_t l = 0; l < 8; ++l) {
        float* out = place(l);
        out[0] = x.v[l];
        out[1] = y.v[l];
        out[2] = z.v[l];
        out[3] = w.v[l];
    }
}

// Eight blocks of nine floats, one after the other.
inline void gather_blocks(const float* group, Eight (&element)[9]) {
    for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t l = 0; l < 8; ++l) element[i].v[l] = group[9 * l + i];
    }
}

// S = sum a b^T over vectors of 4 floats whose fourth is the ratio lambda / mu, and T = sum ratio a b^T.
struct OuterSum {
    float s[9] = {};
    float t[9] = {};
    template <bool is_uniform>
    void add(const float* a, const float* b) {
        for (int c = 0; c < 3; ++c) {
            for (int r = 0; r < 3; ++r) {
                const float product = a[r] * b[c];
                s[3 * c + r] += product;
                if constexpr (!is_uniform) t[3 * c + r] += a[3] * product;
            }
        }
    }
    // block = T + S^T + tr(S) I and its transpose; T is ratio S where the ratio is uniform.
    template <bool is_uniform>
    void store(float ratio, float* block, float* transposed) const {
        const float trace = s[0] + s[4] + s[8];
        for (int c = 0; c < 3; ++c) {
            for (int r = 0; r < 3; ++r) {
                const float first = is_uniform ? ratio * s[3 * c + r] : t[3 * c + r];
                const float value = first + s[3 * r + c] + (r == c ? trace : 0.0f);
                block[3 * c + r] = value;
                transposed[3 * r + c] = value;
            }
        }
    }
};

}
