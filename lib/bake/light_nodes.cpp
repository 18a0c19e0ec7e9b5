// SPDX-License-Identifier: GPL-3.0-or-later
#include "bake/light_nodes.h"

#include <algorithm>
#include <tuple>

#include "bundle/longest_steps.h"
#include "core/counted.h"
#include "core/short_text.h"

namespace crumple::bake {
namespace {

std::string milliseconds(double seconds) { return short_text(1e3 * seconds) + " ms"; }

Place place_of(const Bundle& bundle, Index node) {
    const auto end = bundle.tets.begin() + bundle.solver_tet_count;
    const auto tet = std::find_if(bundle.tets.begin(), end, [&](const Tet& nodes) {
        return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
    });
    const Vec3f p = bundle.rest_positions[node];
    return {{p.x, p.y, p.z}, node, bundle.regions[bundle.region[static_cast<std::size_t>(tet - bundle.tets.begin())]]};
}

}

void warn_of_light_nodes(const Bundle& bundle, double step_s, std::vector<Finding>& findings) {
    const std::vector<double> longest = longest_steps(bundle);
    std::vector<Index> light;
    for (Index node = 0; node < longest.size(); ++node) {
        if (longest[node] < step_s) light.push_back(node);
    }
    if (light.empty()) return;
    std::sort(light.begin(), light.end(),
              [&](Index a, Index b) { return std::tie(longest[a], a) < std::tie(longest[b], b); });
    Finding finding{"STEP_TOO_STIFF",
                    Severity::warning,
                    counted(light.size(), "node is", "nodes are") +
                        " too light beside the stiffness there for steps of " + milliseconds(step_s) +
                        ": the solver makes them heavier, so they answer too slowly; take steps of " +
                        milliseconds(longest[light.front()]) + " at most, a softer material or larger tets",
                    light.size(),
                    {}};
    light.resize(std::min(light.size(), max_places));
    for (const Index node : light) finding.places.push_back(place_of(bundle, node));
    findings.push_back(std::move(finding));
}

}
