// SPDX-License-Identifier: GPL-3.0-or-later
// Which shell component a visual mesh hangs on, where the recipe says so.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "core/finding.h"
#include "mesh/visual_mesh.h"

namespace crumple::importer {

// Fills VisualMesh::shell_component. OWNER_UNKNOWN for names that no visual mesh has; whether the shell has the
// component, `bind` tells.
[[nodiscard]] std::vector<Finding> assign_owners(const std::map<std::string, std::string>& owners,
                                                 std::vector<VisualMesh>& visuals);

}
