// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/exact_integer.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace crumple {

__extension__ using Wide = unsigned __int128;

ExactInteger& ExactInteger::operator=(const ExactInteger& other) {
    sign_ = other.sign_;
    size_ = other.size_;
    std::copy_n(other.limbs_.begin(), size_, limbs_.begin());
    return *this;
}

ExactInteger ExactInteger::from_scaled(std::int64_t mantissa, int shift) {
    ExactInteger result;
    if (mantissa == 0) return result;
    result.sign_ = mantissa < 0 ? -1 : 1;
    const Wide magnitude = static_cast<Wide>(std::llabs(mantissa)) << (shift % 64);
    const int first = shift / 64;
    std::fill_n(result.limbs_.begin(), first, 0u);
    result.limbs_[first] = static_cast<std::uint64_t>(magnitude);
    result.limbs_[first + 1] = static_cast<std::uint64_t>(magnitude >> 64);
    result.size_ = first + 2;
    result.trim();
    return result;
}

void ExactInteger::trim() {
    while (size_ > 0 && limbs_[size_ - 1] == 0) --size_;
    if (size_ == 0) sign_ = 0;
}

int ExactInteger::compare_magnitude(const ExactInteger& a, const ExactInteger& b) {
    if (a.size_ != b.size_) return a.size_ < b.size_ ? -1 : 1;
    for (int i = a.size_ - 1; i >= 0; --i) {
        if (a.limbs_[i] != b.limbs_[i]) return a.limbs_[i] < b.limbs_[i] ? -1 : 1;
    }
    return 0;
}

void ExactInteger::set_sum(const ExactInteger& a, const ExactInteger& b) {
    const ExactInteger& longer = a.size_ >= b.size_ ? a : b;
    const ExactInteger& shorter = a.size_ >= b.size_ ? b : a;
    assert(longer.size_ < capacity);
    Wide carry = 0;
    for (int i = 0; i < longer.size_; ++i) {
        carry += longer.limbs_[i];
        if (i < shorter.size_) carry += shorter.limbs_[i];
        limbs_[i] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
    }
    size_ = longer.size_;
    if (carry != 0) limbs_[size_++] = static_cast<std::uint64_t>(carry);
}

void ExactInteger::set_difference(const ExactInteger& a, const ExactInteger& b) {
    std::uint64_t borrow = 0;
    for (int i = 0; i < a.size_; ++i) {
        const Wide subtrahend = Wide{borrow} + (i < b.size_ ? b.limbs_[i] : 0);
        borrow = a.limbs_[i] < subtrahend ? 1 : 0;
        limbs_[i] = a.limbs_[i] - static_cast<std::uint64_t>(subtrahend);
    }
    size_ = a.size_;
    trim();
}

ExactInteger ExactInteger::add(const ExactInteger& a, const ExactInteger& b, int sign_of_b) {
    if (sign_of_b == 0) return a;
    ExactInteger result;
    if (a.sign_ == sign_of_b) {
        result.sign_ = a.sign_;
        result.set_sum(a, b);
        return result;
    }
    const int order = compare_magnitude(a, b);
    if (order == 0) return result;
    result.sign_ = order > 0 ? a.sign_ : sign_of_b;
    if (order > 0) {
        result.set_difference(a, b);
    } else {
        result.set_difference(b, a);
    }
    return result;
}

ExactInteger operator*(const ExactInteger& a, const ExactInteger& b) {
    ExactInteger result;
    if (a.sign_ == 0 || b.sign_ == 0) return result;
    assert(a.size_ + b.size_ <= ExactInteger::capacity);
    result.sign_ = a.sign_ * b.sign_;
    result.size_ = a.size_ + b.size_;
    std::fill_n(result.limbs_.begin(), result.size_, 0u);
    for (int i = 0; i < a.size_; ++i) {
        Wide carry = 0;
        for (int j = 0; j < b.size_; ++j) {
            carry += Wide{a.limbs_[i]} * b.limbs_[j] + result.limbs_[i + j];
            result.limbs_[i + j] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
        result.limbs_[i + b.size_] = static_cast<std::uint64_t>(carry);
    }
    result.trim();
    return result;
}

}
