// SPDX-License-Identifier: GPL-3.0-or-later
// The largest step that explicit integration of a mesh stands, found rather than bounded.
#pragma once
#include "quality/elastic_system.h"

namespace crumple::quality {

// 2 / sqrt(lambda_max(M^-1 K)) times the speed of sound, metres: at least the step of the worst element, often several
// times that, as the mass of a bad tet's nodes is shared with its neighbours. lambda_max to about 1e-6, from below.
[[nodiscard]] double critical_step(const ElasticSystem& system);

}
