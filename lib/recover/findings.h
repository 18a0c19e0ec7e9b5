// SPDX-License-Identifier: GPL-3.0-or-later
// What a person should know about a recovery, with the places to look at.
#pragma once
#include <vector>

#include "core/finding.h"
#include "mesh/shell.h"
#include "mesh/tet_complex.h"
#include "recover/recovery.h"

namespace crumple::recover {

struct Evidence {
    const Shell& shell;
    const TetComplex& complex;
    const Constraints& constraints;
    const std::vector<Split>& splits;  // that stay
    const Missing<Edge>& edges;
    const Missing<Triangle>& triangles;
};

[[nodiscard]] std::vector<Finding> describe_findings(const Evidence& evidence);

}
