// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/shell_from_scene.h"

#include <algorithm>
#include <iterator>

#include "geometry/measures.h"
#include "importer/clean.h"
#include "importer/components.h"
#include "importer/file_report.h"
#include "importer/flaws.h"
#include "importer/judge.h"
#include "importer/openness.h"
#include "importer/paint.h"
#include "importer/roles.h"
#include "importer/surface.h"
#include "importer/thicken.h"
#include "importer/weld.h"

namespace crumple::importer {

namespace {

void append(std::vector<Finding>& to, std::vector<Finding> from) {
    std::move(from.begin(), from.end(), std::back_inserter(to));
}

// By vertex of the file: whether a triangle uses it. In a vertex list, one whose position is used counts as used.
std::vector<std::uint8_t> used_vertices(const Surface& surface, const std::vector<Vec3>& vertex_list) {
    std::vector<std::uint8_t> used(surface.source_vertex_count, 0);
    if (!surface.has_vertex_list) {
        for (const Triangle& t : surface.triangles) {
            for (const Index v : t) used[surface.source_vertex[v]] = 1;
        }
        return used;
    }
    const auto less = [](const Vec3& a, const Vec3& b) { return lexicographic_less(a, b); };
    std::vector<Vec3> places;
    for (const Triangle& t : surface.triangles) {
        for (const Index v : t) places.push_back(surface.positions[v]);
    }
    std::sort(places.begin(), places.end(), less);
    for (std::size_t v = 0; v < vertex_list.size(); ++v)
        used[v] = std::binary_search(places.begin(), places.end(), vertex_list[v], less) ? 1 : 0;
    return used;
}

Welded weld_and_report(const Surface& surface, const PaintedVertices& painted, const Params& params, Report& report) {
    Welded welded = weld(surface, painted, params.weld_tolerance);
    report.welded = welded.exact_merges;
    report.welded_by_tolerance = welded.tolerance_merges;
    report.weld_distance = welded.farthest;
    report.lock_conflicts = welded.conflicts.count;
    return welded;
}

void clean_and_report(const Surface& surface, Welded& welded, Report& report) {
    const Cleaned cleaned = clean(surface, welded);
    report.repeated_index_triangles = cleaned.repeated_index;
    report.zero_area_triangles = cleaned.zero_area;
    report.duplicate_triangles = cleaned.duplicates;
    append(report.findings, cleaned.findings);
}

Components split_and_report(const Surface& surface, Welded& welded, Report& report) {
    Components components = split_components(surface, welded);
    report.flipped_triangles = components.flipped;
    report.open_edges = components.open_edges;
    report.non_manifold_edges = components.non_manifold_edges;
    append(report.findings, components.findings);
    return components;
}

Components thicken_and_report(const Surface& surface, Components components, double thickness, Welded& welded,
                              Report& report) {
    Finding finding = thicken_sheets(surface, components, thickness, welded);
    if (finding.count == 0) return components;
    report.thickened_triangles = finding.count;
    report.findings.push_back(std::move(finding));
    return split_components(surface, welded);
}

Openness open_and_report(const Shell& shell, const Context& context, Report& report) {
    const Openness openness = measure_openness(shell, context);
    report.holes = openness.holes;
    report.largest_hole = openness.largest_hole;
    report.leak_share = openness.leak_share;
    return openness;
}

Shell shell_from(Welded welded, const Components& components) {
    Shell shell;
    shell.positions = std::move(welded.positions);
    shell.triangles = std::move(welded.triangles);
    shell.color = std::move(welded.colors);
    shell.locked = std::move(welded.locked);
    shell.source_vertex = std::move(welded.source_vertex);
    shell.component = components.of_triangle;
    return shell;
}

void report_components(const Shell& shell, const Components& components, Report& report) {
    for (std::size_t c = 0; c < shell.components.size(); ++c) {
        const Component& component = shell.components[c];
        const std::string parent = component.parent == none ? "" : shell.components[component.parent].name;
        report.components.push_back({component.name, component.material, component.role, component.role_reason, parent,
                                     components.facts[c].triangle_count, component.volume, component.is_closed,
                                     component.is_inward});
    }
}

void report_shell(const Shell& shell, const Components& components, Report& report) {
    report.vertices = shell.positions.size();
    report.triangles = shell.triangles.size();
    report.diagonal = bounding_box(shell.positions).diagonal();
    report.locked = static_cast<std::uint64_t>(std::count(shell.locked.begin(), shell.locked.end(), 1));
    report_components(shell, components, report);
}

}

Shell shell_from_scene(const Scene& scene, const formats::Format& format, const std::string& fallback_name,
                       const Params& params, const Context& context, Report& report) {
    const Placement placement = placement_of(scene, params);
    Surface surface = flatten(scene, placement, params, fallback_name);
    report.shell = report_file("shell", format, placement, scene, surface);
    check_triangle_count(surface.triangles.size());
    append(report.findings, judge_reading(scene, report.shell));
    const PaintedVertices painted = read_paint(scene, format, params, surface);
    report.color_sets = painted.set_count;
    report.painted_copies = painted.locked_count;
    const std::vector<Vec3> vertex_list = place_vertex_list(scene, placement);
    const std::vector<std::uint8_t> is_used = used_vertices(surface, vertex_list);
    report.unused_vertices = static_cast<std::uint64_t>(std::count(is_used.begin(), is_used.end(), 0));
    append(report.findings, judge_unused_locks(scene, vertex_list, is_used));
    append(report.findings, judge_other_paint(scene.unread, painted.set_count));
    append(report.findings, judge_generator(scene, painted.set_count));
    context.stop_if_cancelled();

    Welded welded = weld_and_report(surface, painted, params, report);
    const Finding conflicts = welded.conflicts;
    clean_and_report(surface, welded, report);
    Components components = split_and_report(surface, welded, report);
    if (params.thicken > 0)
        components = thicken_and_report(surface, std::move(components), params.thicken, welded, report);
    Shell shell = shell_from(std::move(welded), components);
    check_usable(shell, report.shell.triangles, placement.unit, params.cage > 0);
    context.stop_if_cancelled();

    append(report.findings, assign_roles(surface, components, params, shell));
    report_shell(shell, components, report);
    append(report.findings, find_flaws(shell, report.diagonal));
    append(report.findings, judge_openness(open_and_report(shell, context, report), report.diagonal, params.cage > 0));
    append(report.findings, judge_shape(shell, context, report.self_intersections));
    append(report.findings, judge_size(report.diagonal, placement));
    append(report.findings, judge_precision(shell, report.diagonal));
    append(report.findings, judge_locks(shell, painted, conflicts, params));
    return shell;
}

}
