// SPDX-License-Identifier: GPL-3.0-or-later
// Signed integers wide enough for every determinant of doubles: the last rung of the exact predicates.
// No heap; only the limbs in use are touched, so small values stay cheap.
#pragma once
#include <array>
#include <cstdint>

namespace crumple {

class ExactInteger {
public:
    // Doubles spread over 2^-1074..2^1023 become integers of 2098 bits; their differences have 33 limbs, and a
    // product of five of them with its sums stays below 5 x 33 + 3 limbs.
    static constexpr int capacity = 168;

    ExactInteger() = default;
    ExactInteger(const ExactInteger& other) { *this = other; }
    ExactInteger& operator=(const ExactInteger& other);

    // mantissa * 2^shift. REQUIRES: 0 <= shift <= 2098, |mantissa| < 2^53.
    [[nodiscard]] static ExactInteger from_scaled(std::int64_t mantissa, int shift);

    [[nodiscard]] int sign() const { return sign_; }

    friend ExactInteger operator+(const ExactInteger& a, const ExactInteger& b) { return add(a, b, b.sign_); }
    friend ExactInteger operator-(const ExactInteger& a, const ExactInteger& b) { return add(a, b, -b.sign_); }
    friend ExactInteger operator*(const ExactInteger& a, const ExactInteger& b);

private:
    static ExactInteger add(const ExactInteger& a, const ExactInteger& b, int sign_of_b);
    static int compare_magnitude(const ExactInteger& a, const ExactInteger& b);
    void set_sum(const ExactInteger& a, const ExactInteger& b);         // |a| + |b|
    void set_difference(const ExactInteger& a, const ExactInteger& b);  // |a| - |b|, |a| >= |b|
    void trim();

    int sign_ = 0;
    int size_ = 0;                               // limbs in use
    std::array<std::uint64_t, capacity> limbs_;  // magnitude, least significant first; undefined from size_ on
};

}
