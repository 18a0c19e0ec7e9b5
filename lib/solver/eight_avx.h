// SPDX-License-Identifier: MIT
// Eight floats for AVX2 and whatever is wider; see lanes_scalar.h for what each piece does. Included once per
// instruction set, with CRUMPLE_LANES naming its namespace.
#pragma once
#include <immintrin.h>

#include <cstddef>

namespace crumple::solver::CRUMPLE_LANES {

struct EightMask {
    __m256 m;
    friend EightMask operator&(EightMask a, EightMask b) { return {_mm256_and_ps(a.m, b.m)}; }
    friend EightMask operator|(EightMask a, EightMask b) { return {_mm256_or_ps(a.m, b.m)}; }
    friend EightMask operator!(EightMask a) { return {_mm256_xor_ps(a.m, _mm256_castsi256_ps(_mm256_set1_epi32(-1)))}; }
};

struct Eight {
    __m256 v;
    static constexpr int width = 8;
    static Eight load(const float* p) { return {_mm256_loadu_ps(p)}; }
    static Eight all(float x) { return {_mm256_set1_ps(x)}; }
    void store(float* p) const { _mm256_storeu_ps(p, v); }
    friend Eight operator+(Eight a, Eight b) { return {_mm256_add_ps(a.v, b.v)}; }
    friend Eight operator-(Eight a, Eight b) { return {_mm256_sub_ps(a.v, b.v)}; }
    friend Eight operator*(Eight a, Eight b) { return {_mm256_mul_ps(a.v, b.v)}; }
    friend Eight operator/(Eight a, Eight b) { return {_mm256_div_ps(a.v, b.v)}; }
    friend EightMask operator>(Eight a, Eight b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ)}; }
    friend EightMask operator<=(Eight a, Eight b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)}; }
};

inline Eight fma(Eight a, Eight b, Eight c) { return {_mm256_fmadd_ps(a.v, b.v, c.v)}; }
inline Eight fnma(Eight a, Eight b, Eight c) { return {_mm256_fnmadd_ps(a.v, b.v, c.v)}; }
inline Eight select(EightMask m, Eight a, Eight b) { return {_mm256_blendv_ps(b.v, a.v, m.m)}; }
inline unsigned bits(EightMask m) { return static_cast<unsigned>(_mm256_movemask_ps(m.m)); }

// Four registers hold, in their two 128-bit parts, (x y z w) of lanes 0 4, 1 5, ...: turn rows into columns.
inline void transpose4(__m256& a, __m256& b, __m256& c, __m256& d) {
    const __m256d ab_low = _mm256_castps_pd(_mm256_unpacklo_ps(a, b));
    const __m256d ab_high = _mm256_castps_pd(_mm256_unpackhi_ps(a, b));
    const __m256d cd_low = _mm256_castps_pd(_mm256_unpacklo_ps(c, d));
    const __m256d cd_high = _mm256_castps_pd(_mm256_unpackhi_ps(c, d));
    a = _mm256_castpd_ps(_mm256_unpacklo_pd(ab_low, cd_low));
    b = _mm256_castpd_ps(_mm256_unpackhi_pd(ab_low, cd_low));
    c = _mm256_castpd_ps(_mm256_unpacklo_pd(ab_high, cd_high));
    d = _mm256_castpd_ps(_mm256_unpackhi_pd(ab_high, cd_high));
}

inline __m256 load_two(const float* a, const float* b) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(a)), _mm_loadu_ps(b), 1);
}

inline void gather3(const float* base, const unsigned* index, Eight& x, Eight& y, Eight& z) {
    const auto at = [&](int i) { return base + 4 * static_cast<std::size_t>(index[i]); };
    __m256 a = load_two(at(0), at(4));
    __m256 b = load_two(at(1), at(5));
    __m256 c = load_two(at(2), at(6));
    __m256 d = load_two(at(3), at(7));
    transpose4(a, b, c, d);
    x.v = a;
    y.v = b;
    z.v = c;
}

template <class Place>
void scatter4(const Place& place, Eight x, Eight y, Eight z, Eight w) {
    __m256 part[4] = {x.v, y.v, z.v, w.v};
    transpose4(part[0], part[1], part[2], part[3]);
    for (std::size_t i = 0; i < 4; ++i) {
        _mm_store_ps(place(i), _mm256_castps256_ps128(part[i]));
        _mm_store_ps(place(i + 4), _mm256_extractf128_ps(part[i], 1));
    }
}

inline void gather_blocks(const float* group, Eight (&element)[9]) {
    for (std::size_t i = 0; i < 8; i += 4) {
        __m256 part[4];
        for (std::size_t l = 0; l < 4; ++l) part[l] = load_two(group + 9 * l + i, group + 9 * (l + 4) + i);
        transpose4(part[0], part[1], part[2], part[3]);
        for (std::size_t k = 0; k < 4; ++k) element[i + k].v = part[k];
    }
    const float* last = group + 8;
    element[8].v = _mm256_setr_ps(last[0], last[9], last[18], last[27], last[36], last[45], last[54], last[63]);
}

}
