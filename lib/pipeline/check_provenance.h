// SPDX-License-Identifier: GPL-3.0-or-later
// What a bundle says of its own making, held against the record of the stages beside it.
#pragma once
#include <vector>

#include "core/finding.h"
#include "pipeline/workspace.h"

namespace crumple::pipeline {

// Errors with the code BUNDLE_PROVENANCE: a tool version that is none, a recipe that is no JSON, and a recipe, stage
// versions or digests of inputs that are other than the record's. A blob has no record and is asked for the first two
// only. Empty when all is true.
[[nodiscard]] std::vector<Finding> check_provenance(const Workspace& workspace);

// A note that a newer program cooked it: this one reads what it knows, and ignores what newer ones add.
[[nodiscard]] std::vector<Finding> tell_of_newer(const BundleProvenance& provenance);

}
