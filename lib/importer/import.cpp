// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/import.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/error.h"
#include "geometry/measures.h"
#include "importer/clean.h"
#include "importer/components.h"
#include "importer/format.h"
#include "importer/judge.h"
#include "importer/paint.h"
#include "importer/printable.h"
#include "importer/read_scene.h"
#include "importer/roles.h"
#include "importer/surface.h"
#include "importer/visual.h"
#include "importer/weld.h"

namespace crumple::importer {

namespace {

void append(std::vector<Finding>& to, std::vector<Finding> from) {
    std::move(from.begin(), from.end(), std::back_inserter(to));
}

FileReport report_file(const std::string& name, const Format& format, const Placement& placement, const Scene& scene,
                       const Surface& surface) {
    FileReport report;
    report.name = name;
    report.format = format.name;
    report.generator = scene.generator;
    report.unit = placement.unit;
    report.up = name_of(placement.up);
    report.meshes = surface.parts.size();
    report.vertices = surface.source_vertex_count;
    report.triangles = surface.triangles.size();
    for (const SceneMesh& mesh : scene.meshes) {
        report.points_and_lines += mesh.points_and_lines;
        report.unreadable_polygons += mesh.unreadable_polygons;
    }
    return report;
}

// Triangles by the file's own count of corners that assimp did not deliver.
std::vector<Finding> judge_reading(const Scene& scene, const FileReport& report) {
    std::vector<Finding> findings;
    std::uint64_t delivered = 0;
    for (const SceneMesh& mesh : scene.meshes) delivered += mesh.triangles.size();
    if (delivered < scene.expected_triangles) {
        const std::uint64_t lost = scene.expected_triangles - delivered;
        findings.push_back(
            {"FILE_FACES_LOST",
             Severity::warning,
             report.name + ": " + std::to_string(lost) + " of " + std::to_string(scene.expected_triangles) +
                 " triangles of the file could not be read (polygons without area, or indices that are not "
                 "there); triangulate before exporting",
             lost,
             {}});
    }
    if (report.points_and_lines > 0) {
        findings.push_back(
            {"FILE_POINTS_AND_LINES",
             Severity::info,
             report.name + ": " + std::to_string(report.points_and_lines) + " points and lines were dropped",
             report.points_and_lines,
             {}});
    }
    return findings;
}

// Blender 3.4 writes the colour of corner number v where that of the corners of vertex v belongs: locks end up
// elsewhere.
std::vector<Finding> judge_generator(const Scene& scene, std::size_t color_set_count) {
    if (color_set_count == 0 || !scene.generator.starts_with("Khronos glTF Blender I/O v3.4.")) return {};
    return {{"COLOR_MAYBE_SCRAMBLED",
             Severity::warning,
             "written by Blender 3.4, whose glTF exporter scrambles colours of the domain Face Corner (what its Vertex "
             "Paint makes by default); make sure the colour attribute is of the domain Vertex, or export FBX",
             1,
             {}}};
}

// Vertices of the file that no triangle uses. In a vertex list, one whose position is used counts as used.
std::uint64_t count_unused(const Surface& surface, const std::vector<Vec3>& vertex_list) {
    if (!surface.has_vertex_list) {
        std::vector<bool> used(surface.source_vertex_count, false);
        for (const Triangle& t : surface.triangles) {
            for (const Index v : t) used[surface.source_vertex[v]] = true;
        }
        return static_cast<std::uint64_t>(std::count(used.begin(), used.end(), false));
    }
    const auto less = [](const Vec3& a, const Vec3& b) { return lexicographic_less(a, b); };
    std::vector<Vec3> used;
    for (const Triangle& t : surface.triangles) {
        for (const Index v : t) used.push_back(surface.positions[v]);
    }
    std::sort(used.begin(), used.end(), less);
    return static_cast<std::uint64_t>(std::count_if(vertex_list.begin(), vertex_list.end(), [&](const Vec3& p) {
        return !std::binary_search(used.begin(), used.end(), p, less);
    }));
}

std::vector<Vec3> locked_positions(const Shell& shell) {
    std::vector<Vec3> positions;
    for (std::size_t v = 0; v < shell.positions.size(); ++v) {
        if (shell.locked[v]) positions.push_back(shell.positions[v]);
    }
    std::sort(positions.begin(), positions.end(),
              [](const Vec3& a, const Vec3& b) { return lexicographic_less(a, b); });
    return positions;
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

std::string stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

Shell make_shell(const std::string& path, const Scene& scene, const Params& params, const Context& context,
                 Report& report) {
    const Format& format = format_of(path);
    const Placement placement = placement_of(scene, params);
    Surface surface = flatten(scene, placement, params, stem_of(path));
    report.shell = report_file("shell", format, placement, scene, surface);
    append(report.findings, judge_reading(scene, report.shell));
    const PaintedVertices painted = read_paint(scene, format, params, surface);
    report.color_sets = painted.set_count;
    append(report.findings, judge_generator(scene, painted.set_count));
    report.painted_copies = painted.locked_count;
    report.unused_vertices = count_unused(surface, place_vertex_list(scene, placement));
    context.stop_if_cancelled();

    Welded welded = weld(surface, painted, params.weld_tolerance);
    report.welded = welded.exact_merges;
    report.welded_by_tolerance = welded.tolerance_merges;
    report.weld_distance = welded.farthest;
    const Cleaned cleaned = clean(surface, welded);
    report.repeated_index_triangles = cleaned.repeated_index;
    report.zero_area_triangles = cleaned.zero_area;
    report.duplicate_triangles = cleaned.duplicates;
    append(report.findings, cleaned.findings);

    const Components components = split_components(surface, welded);
    report.flipped_triangles = components.flipped;
    report.open_edges = components.open_edges;
    report.non_manifold_edges = components.non_manifold_edges;
    append(report.findings, components.findings);
    const Finding conflicts = welded.conflicts;
    Shell shell = shell_from(std::move(welded), components);
    check_usable(shell, report.shell.triangles);
    report.diagonal = bounding_box(shell.positions).diagonal();
    append(report.findings, assign_roles(surface, components, params, shell));
    append(report.findings, judge_shape(shell, context, report.self_intersections));
    append(report.findings, judge_precision(shell, report.diagonal));
    append(report.findings, judge_locks(shell, painted, conflicts, params));
    report_components(shell, components, report);
    report.vertices = shell.positions.size();
    report.triangles = shell.triangles.size();
    report.locked = static_cast<std::uint64_t>(std::count(shell.locked.begin(), shell.locked.end(), 1));
    report.lock_conflicts = conflicts.count;
    return shell;
}

std::vector<std::string> visual_names(const Sources& sources) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const Sources::Visual& visual : sources.visuals) {
        const std::string name = visual.name.empty() ? stem_of(visual.path) : visual.name;
        const bool is_path_like = name.find('/') != std::string::npos || name == "." || name == "..";
        if (name.empty() || is_path_like || name != printable(name)) {
            throw Error(
                ErrorKind::usage,
                "'" + printable(name) + "' cannot name a visual mesh; give another with --visual NAME=" + visual.path);
        }
        if (!taken.insert(name).second) {
            throw Error(ErrorKind::usage, "two visual meshes are named '" + name +
                                              "'; give one another name with --visual NAME=" + visual.path);
        }
        names.push_back(name);
    }
    return names;
}

VisualMesh read_visual(const std::string& name, const std::string& path, const Params& params, Report& report) {
    const Scene scene = load_scene(path, Purpose::visual, params);
    const Placement placement = placement_of(scene, params);
    const Surface surface = flatten(scene, placement, params, name);
    if (surface.positions.empty()) throw Error(ErrorKind::bad_input, "it has no vertices");
    report.visuals.push_back(report_file(name, format_of(path), placement, scene, surface));
    append(report.findings, judge_reading(scene, report.visuals.back()));
    return make_visual(name, surface, place_vertex_list(scene, placement));
}

// Errors of what happens to a file's content after reading begin with its path too.
template <class Function>
auto naming(const std::string& path, Function&& function) {
    try {
        return function();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_input || std::string_view(error.what()).starts_with(path)) throw;
        throw Error(error.kind(), path + ": " + error.what());
    }
}

}

Result import_asset(const Sources& sources, const Params& params, const Context& context) {
    const auto names = visual_names(sources);
    Result result;
    const auto step_count = static_cast<double>(sources.visuals.size() + 2);
    context.tell_progress("import", 0);
    const Scene scene = load_scene(sources.shell, Purpose::shell, params);
    context.tell_progress("import", 1 / step_count);
    result.asset.shell =
        naming(sources.shell, [&] { return make_shell(sources.shell, scene, params, context, result.report); });
    result.asset.locked_positions = locked_positions(result.asset.shell);
    for (std::size_t i = 0; i < names.size(); ++i) {
        context.stop_if_cancelled();
        context.tell_progress("import", (2 + static_cast<double>(i)) / step_count);
        const std::string& path = sources.visuals[i].path;
        result.asset.visuals.push_back(
            naming(path, [&] { return read_visual(names[i], path, params, result.report); }));
    }
    context.tell_progress("import", 1);
    return result;
}

}
