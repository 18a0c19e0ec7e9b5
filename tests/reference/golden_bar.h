// SPDX-License-Identifier: GPL-3.0-or-later
// The bar of 5,326 tets that CalculiX was given for bar_5k_* of calculix_figures.h: 8 x 1 x 1 m, clamped at x = 0.
#pragma once
#include "bundle/bundle.h"

namespace crumple::calculix {

// Reads bar_5k.txt. Throws Error(bad_input) when it is not whole.
[[nodiscard]] Bundle golden_bar(const Material& material);

}
