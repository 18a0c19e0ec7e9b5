// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/bind.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bind/owners.h"
#include "bind/spatial_order.h"
#include "core/parallel_for.h"

namespace crumple::bind {

namespace {

constexpr std::size_t chunk_size = 4096;

void check_input(const Shell& shell, const TetMesh& mesh, std::span<const VisualMesh> visuals) {
    CRUMPLE_CHECK(mesh.region.size() == mesh.tets.size(), "every tet has a region");
    CRUMPLE_CHECK(mesh.neighbours.size() == mesh.tets.size(), "every tet has its neighbours");
    for (const Index region : mesh.region)
        CRUMPLE_CHECK(region < shell.components.size(), "a tet's region is a component");
    for (const Tet& tet : mesh.tets) {
        for (const Index v : tet) CRUMPLE_CHECK(v < mesh.positions.size(), "every corner of a tet is a node");
    }
    for (const VisualMesh& visual : visuals) {
        for (Index v = 0; v < visual.positions.size(); ++v) {
            const Vec3 p = visual.positions[v];
            if (is_finite(p)) continue;
            throw Error(ErrorKind::bad_input, "visual mesh '" + visual.name + "': vertex " + std::to_string(v) +
                                                  " has no finite position; export the mesh again");
        }
    }
    const bool has_vertices =
        std::any_of(visuals.begin(), visuals.end(), [](const VisualMesh& v) { return !v.positions.empty(); });
    if (mesh.tets.empty() && has_vertices)
        throw Error(ErrorKind::bad_input, "bind: there are no tets to hang visual meshes on");
}

VisualBinding bind_one(const VisualMesh& visual, Index owner, const Owners& owners, const Context& context) {
    const std::size_t count = visual.positions.size();
    VisualBinding binding;
    binding.name = visual.name;
    binding.tet.resize(count);
    binding.barycentric.resize(count);
    binding.inside.resize(count);
    binding.distance.resize(count);
    const std::vector<Index> order = spatial_order(visual.positions);
    parallel_for(context, count, chunk_size, [&](std::size_t begin, std::size_t end) {
        context.stop_if_cancelled();
        // Fetched and stored apart from the work: a run of independent cache misses costs little more than one.
        std::vector<Vec3> positions;
        for (std::size_t i = begin; i < end; ++i) positions.push_back(visual.positions[order[i]]);
        std::vector<Location> locations;
        Guess guess;
        for (const Vec3& p : positions) locations.push_back(owners.locate(p, owner, guess));
        for (std::size_t i = begin; i < end; ++i) {
            const Location& location = locations[i - begin];
            const Index v = order[i];
            binding.tet[v] = location.tet;
            binding.barycentric[v] = location.weights;
            binding.inside[v] = location.inside;
            binding.distance[v] = location.distance;
        }
    });
    return binding;
}

double largest_weight(const VisualBinding& binding, Index v) {
    double largest = 0;
    for (const double w : binding.barycentric[v]) largest = std::max(largest, std::fabs(w));
    return largest;
}

VisualReport judge(const VisualBinding& binding, const Params& params) {
    VisualReport report;
    report.name = binding.name;
    report.vertices = binding.tet.size();
    double distances = 0;
    for (Index v = 0; v < binding.tet.size(); ++v) {
        const double largest = largest_weight(binding, v);
        report.max_weight = std::max(report.max_weight, largest);
        report.extrapolated += largest > params.max_weight;
        if (binding.inside[v]) continue;
        ++report.outside;
        distances += binding.distance[v];
        report.max_distance = std::max(report.max_distance, binding.distance[v]);
    }
    if (report.outside > 0) report.mean_distance = distances / static_cast<double>(report.outside);
    return report;
}

std::string rounded(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", number);
    return text;
}

// The vertices that pull hardest come first.
Finding extrapolation_finding(const VisualMesh& visual, const VisualBinding& binding, const VisualReport& report,
                              const Params& params) {
    std::vector<std::pair<double, Index>> worst;
    for (Index v = 0; v < binding.tet.size(); ++v) {
        const double largest = largest_weight(binding, v);
        if (largest > params.max_weight) worst.push_back({-largest, v});
    }
    const auto shown = std::min(worst.size(), max_places);
    std::partial_sort(worst.begin(), worst.begin() + static_cast<std::ptrdiff_t>(shown), worst.end());
    Finding finding{"BIND_EXTRAPOLATED",
                    Severity::warning,
                    "vertices of visual mesh '" + visual.name + "' lie so far outside that a weight reaches " +
                        rounded(report.max_weight) +
                        ": they exaggerate what their tet does; let the shell enclose them or use coarser tets there",
                    report.extrapolated,
                    {}};
    for (std::size_t i = 0; i < shown; ++i) {
        const Index v = worst[i].second;
        finding.places.push_back({visual.positions[v], v, visual.name});
    }
    return finding;
}

// What to hang a visual mesh on, and a finding when that is not what it asked for.
Index choose_owner(const VisualMesh& visual, const Owners& owners, std::vector<Finding>& findings) {
    if (visual.shell_component.empty()) return none;
    const Index owner = owners.component(visual.shell_component);
    const std::string who =
        "visual mesh '" + visual.name + "' asks for shell component '" + visual.shell_component + "', ";
    if (owner == none) {
        findings.push_back({"BIND_UNKNOWN_OWNER",
                            Severity::warning,
                            who + "which is not there: it hangs on whichever is nearest",
                            1,
                            {}});
        return none;
    }
    if (!owners.has_tets(owner)) {
        findings.push_back({"BIND_OWNER_WITHOUT_TETS",
                            Severity::warning,
                            who + "which has no tets: it hangs on whichever is nearest",
                            1,
                            {}});
        return none;
    }
    return owner;
}

void add(Report& report, const VisualReport& visual) {
    report.vertices += visual.vertices;
    report.outside += visual.outside;
    report.max_distance = std::max(report.max_distance, visual.max_distance);
    report.max_weight = std::max(report.max_weight, visual.max_weight);
    report.extrapolated += visual.extrapolated;
    report.visuals.push_back(visual);
}

}

Result bind_visuals(const Shell& shell, const TetMesh& mesh, std::span<const VisualMesh> visuals, const Params& params,
                    const Context& context) {
    check_input(shell, mesh, visuals);
    Owners owners(shell, mesh, params);
    Result result;
    for (const VisualMesh& visual : visuals) {
        context.tell_progress("binding " + visual.name,
                              static_cast<double>(result.bindings.size()) / static_cast<double>(visuals.size()));
        const Index owner = choose_owner(visual, owners, result.report.findings);
        if (!visual.positions.empty()) owners.prepare(owner);
        result.bindings.push_back(bind_one(visual, owner, owners, context));
        VisualReport report = judge(result.bindings.back(), params);
        if (owner != none) report.owner = visual.shell_component;
        add(result.report, report);
        if (report.extrapolated > 0) {
            result.report.findings.push_back(extrapolation_finding(visual, result.bindings.back(), report, params));
        }
    }
    return result;
}

}
