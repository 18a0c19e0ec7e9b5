// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as text for people: few digits, no locale. JSON writes its own, which read back exactly.
#pragma once
#include <cstdint>
#include <string>

namespace crumple::report {

// So many significant digits at most: "0.25", "1e+13", "inf", "nan".
[[nodiscard]] std::string number_text(double number, int digits = 6);

// The shortest digits that read back as the same float.
[[nodiscard]] std::string float_text(float number);

// "312 B", "5.9 MB": powers of 1000.
[[nodiscard]] std::string size_text(std::uint64_t bytes);

}
