// SPDX-License-Identifier: MIT
// Eight lanes: AVX2 with FMA. The same interface as lanes_scalar.h, which says what each piece does.
#pragma once
#include <immintrin.h>

#include <cstddef>
#include <cstdint>

#include "solver/eight_avx.h"

namespace crumple::solver::avx2 {

using Mask = EightMask;
using Lanes = Eight;

inline Lanes root(Lanes a) { return {_mm256_sqrt_ps(a.v)}; }
inline Lanes max(Lanes a, Lanes b) { return {_mm256_max_ps(a.v, b.v)}; }
inline Lanes min(Lanes a, Lanes b) { return {_mm256_min_ps(a.v, b.v)}; }
inline Lanes abs(Lanes a) { return {_mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v)}; }
inline Mask mask_of(unsigned b) {
    const __m256i bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i hit = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(b)), bit);
    return {_mm256_castsi256_ps(_mm256_cmpeq_epi32(hit, bit))};
}

inline Lanes look_up(const float (&table)[8], const std::uint8_t* index) {
    const __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(index));
    return {_mm256_permutevar8x32_ps(_mm256_loadu_ps(table), _mm256_cvtepu8_epi32(bytes))};
}
inline unsigned nonzero_bytes(const std::uint8_t* bytes) {
    const __m128i eight = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(bytes));
    return ~static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpeq_epi8(eight, _mm_setzero_si128()))) & 0xffu;
}

inline void scatter4(float* out, std::size_t stride, Lanes x, Lanes y, Lanes z, Lanes w) {
    scatter4([&](std::size_t l) { return out + stride * l; }, x, y, z, w);
}

struct Quads {
    __m256 v;
    static constexpr int nodes = 2;
    static Quads load(const float* p) { return {_mm256_load_ps(p)}; }
    static Quads all(float x) { return {_mm256_set1_ps(x)}; }
    void store(float* p) const { _mm256_store_ps(p, v); }
    friend Quads operator+(Quads a, Quads b) { return {_mm256_add_ps(a.v, b.v)}; }
    friend Quads operator*(Quads a, Quads b) { return {_mm256_mul_ps(a.v, b.v)}; }
};

inline Quads fma(Quads a, Quads b, Quads c) { return {_mm256_fmadd_ps(a.v, b.v, c.v)}; }
template <int component>
Quads spread(Quads a) {
    return {_mm256_permute_ps(a.v, component * 0x55)};
}
inline float sum(Quads a) {
    const __m128 quad = _mm_add_ps(_mm256_castps256_ps128(a.v), _mm256_extractf128_ps(a.v, 1));
    const __m128 pair = _mm_add_ps(quad, _mm_movehl_ps(quad, quad));
    return _mm_cvtss_f32(_mm_add_ss(pair, _mm_movehdup_ps(pair)));
}

// Columns 0 and 1 share a register, column 2 has its own.
struct OuterSum {
    __m256 s01 = _mm256_setzero_ps();
    __m128 s2 = _mm_setzero_ps();
    __m256 t01 = _mm256_setzero_ps();
    __m128 t2 = _mm_setzero_ps();
    template <bool is_uniform>
    void add(const float* a, const float* b) {
        const __m128 rows = _mm_load_ps(a);
        const __m256 rows_twice = _mm256_set_m128(rows, rows);
        const __m256 columns = _mm256_set_m128(_mm_broadcast_ss(b + 1), _mm_broadcast_ss(b));
        const __m128 column = _mm_broadcast_ss(b + 2);
        if constexpr (is_uniform) {
            s01 = _mm256_fmadd_ps(rows_twice, columns, s01);
            s2 = _mm_fmadd_ps(rows, column, s2);
        } else {
            const __m256 product01 = _mm256_mul_ps(rows_twice, columns);
            const __m128 product2 = _mm_mul_ps(rows, column);
            s01 = _mm256_add_ps(s01, product01);
            s2 = _mm_add_ps(s2, product2);
            t01 = _mm256_fmadd_ps(_mm256_broadcast_ss(a + 3), product01, t01);
            t2 = _mm_fmadd_ps(_mm_broadcast_ss(a + 3), product2, t2);
        }
    }
    template <bool is_uniform>
    void store(float ratio, float* block, float* transposed) const {
        __m128 c0 = _mm256_castps256_ps128(s01);
        __m128 c1 = _mm256_extractf128_ps(s01, 1);
        __m128 c2 = s2;
        __m128 r0 = c0, r1 = c1, r2 = c2, r3 = _mm_setzero_ps();
        _MM_TRANSPOSE4_PS(r0, r1, r2, r3);
        const __m128 trace =
            _mm_add_ps(_mm_permute_ps(c0, 0x00), _mm_add_ps(_mm_permute_ps(c1, 0x55), _mm_permute_ps(c2, 0xaa)));
        const __m128 zero = _mm_setzero_ps();
        const __m128 ratios = _mm_set1_ps(ratio);
        __m128 k0 = _mm_mul_ps(ratios, c0), k1 = _mm_mul_ps(ratios, c1), k2 = _mm_mul_ps(ratios, c2);
        if constexpr (!is_uniform) {
            k0 = _mm256_castps256_ps128(t01);
            k1 = _mm256_extractf128_ps(t01, 1);
            k2 = t2;
        }
        k0 = _mm_add_ps(_mm_add_ps(k0, r0), _mm_blend_ps(zero, trace, 1));
        k1 = _mm_add_ps(_mm_add_ps(k1, r1), _mm_blend_ps(zero, trace, 2));
        k2 = _mm_add_ps(_mm_add_ps(k2, r2), _mm_blend_ps(zero, trace, 4));
        __m128 q0 = k0, q1 = k1, q2 = k2, q3 = zero;
        _MM_TRANSPOSE4_PS(q0, q1, q2, q3);
        store9(block, k0, k1, k2);
        store9(transposed, q0, q1, q2);
    }

private:
    // The fourth lane of each column is overwritten by the next; the last column goes in two pieces.
    static void store9(float* block, __m128 c0, __m128 c1, __m128 c2) {
        _mm_storeu_ps(block, c0);
        _mm_storeu_ps(block + 3, c1);
        _mm_storel_pi(reinterpret_cast<__m64*>(block + 6), c2);
        _mm_store_ss(block + 8, _mm_movehl_ps(c2, c2));
    }
};

}
