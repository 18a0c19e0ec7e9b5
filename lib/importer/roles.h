// SPDX-License-Identifier: GPL-3.0-or-later
// Names the components of a shell and decides what each encloses: by the recipe's word, else from
// paint, winding and nesting.
#pragma once
#include <vector>

#include "core/finding.h"
#include "importer/components.h"
#include "importer/import.h"

namespace crumple::importer {

// Fills shell.components and turns each component's triangles as its role wants them: outwards, a cavity's inwards.
// REQUIRES: shell.positions, triangles, locked and component are set.
[[nodiscard]] std::vector<Finding> assign_roles(const Surface& surface, const Components& components,
                                                const Params& params, Shell& shell);

}
