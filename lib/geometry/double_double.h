// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of about 104 bits as an unevaluated sum of two doubles [Dekker 1971; Hida, Li, Bailey 2001].
// Every operation is off by at most 2^-102 (|a| + |b|) for sums and 2^-102 |a b| for products, away from over- and
// underflow: the cheap sum, whose error is relative to the magnitudes and not to the result, is all a filter needs.
#pragma once
#include <cmath>

namespace crumple {

struct DoubleDouble {
    double high = 0;
    double low = 0;

    // a - b without error.
    static DoubleDouble difference(double a, double b) {
        const double rounded = a - b;
        const double b_part = a - rounded;
        return {rounded, (a - (rounded + b_part)) + (b_part - b)};
    }

    friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
        const double sum = a.high + b.high;
        const double b_part = sum - a.high;
        const double error = (a.high - (sum - b_part)) + (b.high - b_part);
        return normalised(sum, error + (a.low + b.low));
    }
    friend DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }
    friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }
    friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
        const double product = a.high * b.high;
        // Inside a function compiled for FMA this is one instruction; the C library is exact elsewhere.
        const double error = std::fma(a.high, b.high, -product);
        return normalised(product, error + (a.high * b.low + a.low * b.high));
    }

private:
    // REQUIRES: |b| far below |a|, or a = 0.
    static DoubleDouble normalised(double a, double b) {
        const double sum = a + b;
        return {sum, b - (sum - a)};
    }
};

}
