// SPDX-License-Identifier: MIT
// A sum of 3 x 3 blocks times vectors for AVX2 and whatever is wider; see lanes_scalar.h for what it does.
// Included once per instruction set, with CRUMPLE_LANES naming its namespace.
#pragma once
#include <immintrin.h>

namespace crumple::solver::CRUMPLE_LANES {

// Eight elements in one register and the ninth in another: wider loads of 36 bytes would straddle two cache lines
// nearly always. Two sums of each, or every addition would wait for the one before.
struct RowSum {
    __m256 even = _mm256_setzero_ps();
    __m256 odd = _mm256_setzero_ps();
    __m128 last_even = _mm_setzero_ps();  // lane 3 counts
    __m128 last_odd = _mm_setzero_ps();

    void add(const float* block, const float* x) { add(block, _mm_load_ps(x), even, last_even); }
    void add_pair(const float* blocks, const float* x, const float* next_x) {
        add(blocks, _mm_load_ps(x), even, last_even);
        add(blocks + 9, _mm_load_ps(next_x), odd, last_odd);
    }
    void store(float* y) const {
        const __m256 eight = _mm256_add_ps(even, odd);
        const __m128 last = _mm_add_ps(last_even, last_odd);
        const __m128 first = _mm256_castps256_ps128(eight);
        const __m128 second = _mm256_castps256_ps128(pick(eight, 3, 4, 5));
        const __m128 third = _mm_insert_ps(_mm256_castps256_ps128(pick(eight, 6, 7, 7)), last,
                                           0xe8);  // element 3 to lane 2, lane 3 zero
        const __m128 sum = _mm_add_ps(_mm_add_ps(first, second), third);
        _mm_store_ps(y, _mm_blend_ps(sum, _mm_setzero_ps(), 8));
    }

private:
    static void add(const float* block, __m128 x, __m256& eight, __m128& last) {
        const __m256 spread =
            _mm256_permutevar8x32_ps(_mm256_castps128_ps256(x), _mm256_setr_epi32(0, 0, 0, 1, 1, 1, 2, 2));
        eight = _mm256_fmadd_ps(_mm256_loadu_ps(block), spread, eight);
        last = _mm_fmadd_ps(_mm_loadu_ps(block + 5), _mm_permute_ps(x, 0xbf), last);  // w w w z
    }
    static __m256 pick(__m256 from, int a, int b, int c) {
        return _mm256_permutevar8x32_ps(from, _mm256_setr_epi32(a, b, c, c, c, c, c, c));
    }
};

}
