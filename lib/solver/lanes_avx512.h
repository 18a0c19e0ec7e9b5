// SPDX-License-Identifier: MIT
// Sixteen lanes: AVX-512 F, VL, DQ, BW. The same interface as lanes_scalar.h, which says what each piece does.
#pragma once
#include <immintrin.h>

#include <cstddef>
#include <cstdint>

#include "solver/eight_avx.h"

namespace crumple::solver::avx512 {

struct Mask {
    __mmask16 m;
    friend Mask operator&(Mask a, Mask b) { return {static_cast<__mmask16>(a.m & b.m)}; }
    friend Mask operator|(Mask a, Mask b) { return {static_cast<__mmask16>(a.m | b.m)}; }
    friend Mask operator!(Mask a) { return {static_cast<__mmask16>(~a.m)}; }
};

struct Lanes {
    __m512 v;
    static constexpr int width = 16;
    static Lanes load(const float* p) { return {_mm512_loadu_ps(p)}; }
    static Lanes all(float x) { return {_mm512_set1_ps(x)}; }
    void store(float* p) const { _mm512_storeu_ps(p, v); }
    friend Lanes operator+(Lanes a, Lanes b) { return {_mm512_add_ps(a.v, b.v)}; }
    friend Lanes operator-(Lanes a, Lanes b) { return {_mm512_sub_ps(a.v, b.v)}; }
    friend Lanes operator*(Lanes a, Lanes b) { return {_mm512_mul_ps(a.v, b.v)}; }
    friend Lanes operator/(Lanes a, Lanes b) { return {_mm512_div_ps(a.v, b.v)}; }
    friend Mask operator>(Lanes a, Lanes b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_GT_OQ)}; }
    friend Mask operator<=(Lanes a, Lanes b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ)}; }
};

inline Lanes fma(Lanes a, Lanes b, Lanes c) { return {_mm512_fmadd_ps(a.v, b.v, c.v)}; }
inline Lanes fnma(Lanes a, Lanes b, Lanes c) { return {_mm512_fnmadd_ps(a.v, b.v, c.v)}; }
inline Lanes root(Lanes a) { return {_mm512_sqrt_ps(a.v)}; }
inline Lanes max(Lanes a, Lanes b) { return {_mm512_max_ps(a.v, b.v)}; }
inline Lanes min(Lanes a, Lanes b) { return {_mm512_min_ps(a.v, b.v)}; }
inline Lanes abs(Lanes a) { return {_mm512_abs_ps(a.v)}; }
inline Lanes select(Mask m, Lanes a, Lanes b) { return {_mm512_mask_blend_ps(m.m, b.v, a.v)}; }
inline unsigned bits(Mask m) { return m.m; }
inline Mask mask_of(unsigned b) { return {static_cast<__mmask16>(b)}; }

inline Lanes look_up(const float (&table)[8], const std::uint8_t* index) {
    const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(index));
    const __m512 both_halves = _mm512_broadcast_f32x8(_mm256_loadu_ps(table));
    return {_mm512_permutexvar_ps(_mm512_cvtepu8_epi32(bytes), both_halves)};
}
inline unsigned nonzero_bytes(const std::uint8_t* bytes) {
    const __m128i sixteen = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes));
    return _mm_test_epi8_mask(sixteen, sixteen);
}

// Four registers hold, in their four 128-bit parts, (x y z w) of lanes 0 4 8 12, 1 5 9 13, ...: turn rows into columns.
inline void transpose4(__m512& a, __m512& b, __m512& c, __m512& d) {
    const __m512d ab_low = _mm512_castps_pd(_mm512_unpacklo_ps(a, b));
    const __m512d ab_high = _mm512_castps_pd(_mm512_unpackhi_ps(a, b));
    const __m512d cd_low = _mm512_castps_pd(_mm512_unpacklo_ps(c, d));
    const __m512d cd_high = _mm512_castps_pd(_mm512_unpackhi_ps(c, d));
    a = _mm512_castpd_ps(_mm512_unpacklo_pd(ab_low, cd_low));
    b = _mm512_castpd_ps(_mm512_unpackhi_pd(ab_low, cd_low));
    c = _mm512_castpd_ps(_mm512_unpacklo_pd(ab_high, cd_high));
    d = _mm512_castpd_ps(_mm512_unpackhi_pd(ab_high, cd_high));
}

inline __m512 load_parts(const float* base, const unsigned* index) {
    const auto at = [&](int i) { return _mm_load_ps(base + 4 * static_cast<std::size_t>(index[i])); };
    __m512 r = _mm512_castps128_ps512(at(0));
    r = _mm512_insertf32x4(r, at(4), 1);
    r = _mm512_insertf32x4(r, at(8), 2);
    return _mm512_insertf32x4(r, at(12), 3);
}

inline void gather3(const float* base, const unsigned* index, Lanes& x, Lanes& y, Lanes& z) {
    __m512 a = load_parts(base, index);
    __m512 b = load_parts(base, index + 1);
    __m512 c = load_parts(base, index + 2);
    __m512 d = load_parts(base, index + 3);
    transpose4(a, b, c, d);
    x.v = a;
    y.v = b;
    z.v = c;
}

inline void scatter4(float* out, std::size_t stride, Lanes x, Lanes y, Lanes z, Lanes w) {
    __m512 part[4] = {x.v, y.v, z.v, w.v};
    transpose4(part[0], part[1], part[2], part[3]);
    for (std::size_t i = 0; i < 4; ++i) {
        _mm_store_ps(out + stride * i, _mm512_castps512_ps128(part[i]));
        _mm_store_ps(out + stride * (i + 4), _mm512_extractf32x4_ps(part[i], 1));
        _mm_store_ps(out + stride * (i + 8), _mm512_extractf32x4_ps(part[i], 2));
        _mm_store_ps(out + stride * (i + 12), _mm512_extractf32x4_ps(part[i], 3));
    }
}

struct Quads {
    __m512 v;
    static constexpr int nodes = 4;
    static Quads load(const float* p) { return {_mm512_load_ps(p)}; }
    static Quads all(float x) { return {_mm512_set1_ps(x)}; }
    void store(float* p) const { _mm512_store_ps(p, v); }
    friend Quads operator+(Quads a, Quads b) { return {_mm512_add_ps(a.v, b.v)}; }
    friend Quads operator*(Quads a, Quads b) { return {_mm512_mul_ps(a.v, b.v)}; }
};

inline Quads fma(Quads a, Quads b, Quads c) { return {_mm512_fmadd_ps(a.v, b.v, c.v)}; }
template <int component>
Quads spread(Quads a) {
    return {_mm512_permute_ps(a.v, component * 0x55)};
}
inline float sum(Quads a) {
    const __m256 half = _mm256_add_ps(_mm512_castps512_ps256(a.v), _mm512_extractf32x8_ps(a.v, 1));
    const __m128 quad = _mm_add_ps(_mm256_castps256_ps128(half), _mm256_extractf128_ps(half, 1));
    const __m128 pair = _mm_add_ps(quad, _mm_movehl_ps(quad, quad));
    return _mm_cvtss_f32(_mm_add_ss(pair, _mm_movehdup_ps(pair)));
}

inline constexpr __mmask16 nine = 0x1ff;

// Lane 4 c + r of the sums is element (r, c).
struct OuterSum {
    __m512 s = _mm512_setzero_ps();
    __m512 t = _mm512_setzero_ps();
    template <bool is_uniform>
    void add(const float* a, const float* b) {
        const __m512i columns = _mm512_setr_epi32(0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3);
        const __m512 rows_a = _mm512_broadcast_f32x4(_mm_load_ps(a));
        const __m512 columns_b = _mm512_permutexvar_ps(columns, _mm512_castps128_ps512(_mm_load_ps(b)));
        if constexpr (is_uniform) {
            s = _mm512_fmadd_ps(rows_a, columns_b, s);
        } else {
            const __m512 product = _mm512_mul_ps(rows_a, columns_b);
            s = _mm512_add_ps(s, product);
            t = _mm512_fmadd_ps(_mm512_permute_ps(rows_a, 0xff), product, t);
        }
    }
    template <bool is_uniform>
    void store(float ratio, float* block, float* transposed) const {
        const __m512i packed = _mm512_setr_epi32(0, 1, 2, 4, 5, 6, 8, 9, 10, 15, 15, 15, 15, 15, 15, 15);
        const __m512i turned = _mm512_setr_epi32(0, 4, 8, 1, 5, 9, 2, 6, 10, 15, 15, 15, 15, 15, 15, 15);
        const __m512 s_packed = _mm512_permutexvar_ps(packed, s);
        const __m512 s_turned = _mm512_permutexvar_ps(turned, s);
        const __m512 trace = _mm512_add_ps(_mm512_permutexvar_ps(_mm512_set1_epi32(0), s),
                                           _mm512_add_ps(_mm512_permutexvar_ps(_mm512_set1_epi32(5), s),
                                                         _mm512_permutexvar_ps(_mm512_set1_epi32(10), s)));
        const __m512 diagonal = _mm512_maskz_mov_ps(0x111, trace);
        const __m512 ratios = _mm512_set1_ps(ratio);
        __m512 first = _mm512_mul_ps(ratios, s_packed);
        __m512 second = _mm512_mul_ps(ratios, s_turned);
        if constexpr (!is_uniform) {
            first = _mm512_permutexvar_ps(packed, t);
            second = _mm512_permutexvar_ps(turned, t);
        }
        _mm512_mask_storeu_ps(block, nine, _mm512_add_ps(_mm512_add_ps(first, s_turned), diagonal));
        _mm512_mask_storeu_ps(transposed, nine, _mm512_add_ps(_mm512_add_ps(second, s_packed), diagonal));
    }
};

}
