// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/owners.h"

#include <algorithm>

namespace crumple::importer {

std::vector<Finding> assign_owners(const std::map<std::string, std::string>& owners, std::vector<VisualMesh>& visuals) {
    std::vector<Finding> findings;
    for (const auto& [name, component] : owners) {
        const auto visual =
            std::find_if(visuals.begin(), visuals.end(), [&wanted = name](const auto& v) { return v.name == wanted; });
        if (visual != visuals.end()) {
            visual->shell_component = component;
            continue;
        }
        findings.push_back({"OWNER_UNKNOWN",
                            Severity::warning,
                            "the recipe gives visual mesh '" + name +
                                "' an owner, but none has that name; name one with --visual " + name + "=FILE",
                            1,
                            {}});
    }
    return findings;
}

}
