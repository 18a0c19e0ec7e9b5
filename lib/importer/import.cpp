// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/import.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/error.h"
#include "formats/format.h"
#include "formats/printable.h"
#include "geometry/measures.h"
#include "importer/cage.h"
#include "importer/file_report.h"
#include "importer/owners.h"
#include "importer/read_scene.h"
#include "importer/shell_from_scene.h"
#include "importer/surface.h"
#include "importer/visual.h"

namespace crumple::importer {

namespace {

std::vector<Vec3> locked_positions(const Shell& shell) {
    std::vector<Vec3> positions;
    for (std::size_t v = 0; v < shell.positions.size(); ++v) {
        if (shell.locked[v]) positions.push_back(shell.positions[v]);
    }
    std::sort(positions.begin(), positions.end(),
              [](const Vec3& a, const Vec3& b) { return lexicographic_less(a, b); });
    return positions;
}

std::string stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

// Figures of the shell that goes on; the components reported stay those of the file.
void cage_and_report(Result& result, std::uint32_t cells, const Context& context) {
    Report& report = result.report;
    report.findings.push_back(put_in_cage(result.asset, cells, context));
    const Shell& shell = result.asset.shell;
    report.vertices = shell.positions.size();
    report.triangles = shell.triangles.size();
    report.diagonal = bounding_box(shell.positions).diagonal();
    report.locked = static_cast<std::uint64_t>(std::count(shell.locked.begin(), shell.locked.end(), 1));
}

VisualMesh read_visual(const std::string& name, const std::string& path, const Params& params, Report& report) {
    const Scene scene = load_scene(path, formats::Purpose::visual, params);
    const Placement placement = placement_of(scene, params);
    const Surface surface = flatten(scene, placement, params, name);
    if (surface.positions.empty()) throw Error(ErrorKind::bad_input, "it has no vertices");
    report.visuals.push_back(report_file(name, formats::format_of(path), placement, scene, surface));
    for (Finding& finding : judge_reading(scene, report.visuals.back())) report.findings.push_back(std::move(finding));
    return make_visual(name, surface, place_vertex_list(scene, placement));
}

// Errors of what happens to a file's content after reading begin with its path too.
template <class Function>
auto naming(const std::string& path, Function&& function) {
    try {
        return function();
    } catch (const Error& error) {
        const bool is_about_content = error.kind() == ErrorKind::bad_input || error.kind() == ErrorKind::usage;
        if (!is_about_content || std::string_view(error.what()).starts_with(path)) throw;
        throw Error(error.kind(), path + ": " + error.what());
    }
}

}

std::vector<std::string> visual_names(const Sources& sources) {
    std::vector<std::string> names;
    std::set<std::string> taken;
    for (const Sources::Visual& visual : sources.visuals) {
        if (visual.path.empty()) throw Error(ErrorKind::usage, "--visual: it names no file");
        const std::string name = visual.name.empty() ? stem_of(visual.path) : visual.name;
        const bool is_path_like = name.find('/') != std::string::npos || name == "." || name == "..";
        if (name.empty() || is_path_like || name != formats::printable(name)) {
            throw Error(ErrorKind::usage, "--visual: " + formats::in_quotes(name) +
                                              " cannot name a visual mesh: a name is text without '/' that is not "
                                              "empty, at most " +
                                              std::to_string(formats::max_name_bytes) +
                                              " bytes; give one with --visual NAME=" + visual.path);
        }
        if (!taken.insert(name).second) {
            throw Error(ErrorKind::usage, "--visual: two visual meshes are named '" + name +
                                              "'; give one another name with --visual NAME=" + visual.path);
        }
        names.push_back(name);
    }
    return names;
}

std::vector<std::string> shell_object_names(const Sources& sources, const Params& params) {
    const Scene scene = load_scene(sources.shell, formats::Purpose::shell, params);
    return naming(sources.shell, [&] {
        std::vector<std::string> names;
        Surface surface = flatten(scene, placement_of(scene, params), params, stem_of(sources.shell));
        for (Object& object : surface.objects) names.push_back(std::move(object.name));
        return names;
    });
}

Result import_asset(const Sources& sources, const Params& params, const Context& context) {
    const auto names = visual_names(sources);
    Result result;
    const auto step_count = static_cast<double>(sources.visuals.size() + 2);
    context.tell_progress("import", 0);
    const Scene scene = load_scene(sources.shell, formats::Purpose::shell, params);
    context.tell_progress("import", 1 / step_count);
    result.asset.shell = naming(sources.shell, [&] {
        return shell_from_scene(scene, formats::format_of(sources.shell), stem_of(sources.shell), params, context,
                                result.report);
    });
    for (std::size_t i = 0; i < names.size(); ++i) {
        context.stop_if_cancelled();
        context.tell_progress("import", (2 + static_cast<double>(i)) / step_count);
        const std::string& path = sources.visuals[i].path;
        result.asset.visuals.push_back(
            naming(path, [&] { return read_visual(names[i], path, params, result.report); }));
    }
    for (Finding& finding : assign_owners(params.owners, result.asset.visuals))
        result.report.findings.push_back(std::move(finding));
    if (params.cage > 0) cage_and_report(result, params.cage, context);
    result.asset.locked_positions = locked_positions(result.asset.shell);
    context.tell_progress("import", 1);
    return result;
}

}
