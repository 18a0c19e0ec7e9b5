// SPDX-License-Identifier: MIT
// Recomputes every invariant of a bundle from scratch. A bundle that passes can be stepped without bounds checks.
#pragma once
#include <vector>

#include "bundle/bundle.h"
#include "core/finding.h"

namespace crumple {

// Errors are findings of Severity::error with codes BUNDLE_*; empty when all is well. Never reads out of bounds,
// whatever the arrays hold.
[[nodiscard]] std::vector<Finding> validate(const Bundle& bundle);

}
