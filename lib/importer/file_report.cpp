// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/file_report.h"
#include "core/counted.h"

namespace crumple::importer {

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
    if (scene.unread.free_form > 0) {
        findings.push_back({"FILE_FREE_FORM",
                            Severity::warning,
                            report.name + ": " +
                                counted(scene.unread.free_form, "free-form curve or surface was",
                                        "free-form curves and surfaces were") +
                                " not read; convert to polygons what belongs to the surface",
                            scene.unread.free_form,
                            {}});
    }
    if (scene.unread.bytes > 0) {
        findings.push_back({"FILE_UNREAD",
                            Severity::warning,
                            report.name + ": " + counted(scene.unread.bytes, "byte follows", "bytes follow") +
                                " the last element that the header announces and " +
                                (scene.unread.bytes == 1 ? "was" : "were") +
                                " not read; are the counts in the header too small?",
                            scene.unread.bytes,
                            {}});
    }
    if (report.points_and_lines > 0) {
        findings.push_back({"FILE_POINTS_AND_LINES",
                            Severity::info,
                            report.name + ": " +
                                counted(report.points_and_lines, "point or line was", "points and lines were") +
                                " dropped",
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

}
