// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/file_report.h"

#include <algorithm>

#include "core/counted.h"

namespace crumple::importer {

FileReport report_file(const std::string& name, const formats::Format& format, const Placement& placement,
                       const Scene& scene, const Surface& surface) {
    FileReport report;
    report.name = name;
    report.format = format.name;
    report.generator = scene.generator;
    report.unit = placement.unit;
    report.up = name_of(placement.up);
    report.meshes = surface.parts.size();
    report.vertices = surface.source_vertex_count;
    report.triangles = surface.triangles.size();
    report.points_and_lines = scene.unread.points_and_lines;
    for (const SceneMesh& mesh : scene.meshes) {
        report.points_and_lines += mesh.points_and_lines;
        report.unreadable_polygons += mesh.unreadable_polygons;
    }
    return report;
}

namespace {

Finding told(const char* code, Severity severity, const FileReport& report, const std::string& message,
             std::uint64_t count) {
    return {code, severity, report.name + ": " + message, count, {}};
}

void judge_faces(const Scene& scene, const FileReport& report, std::vector<Finding>& findings) {
    const std::uint64_t lost = scene.lost_triangles();
    if (lost == 0) return;
    findings.push_back(told("FILE_FACES_LOST", Severity::warning, report,
                            std::to_string(lost) + " of " + std::to_string(scene.expected_triangles) +
                                " triangles of the file could not be read (polygons without area, or indices that are "
                                "not there); triangulate before exporting",
                            lost));
}

void judge_nodes(const Scene& scene, const FileReport& report, std::vector<Finding>& findings) {
    if (const std::uint64_t count = scene.unread.nodes_of_no_scene; count > 0) {
        findings.push_back(told("FILE_NO_SCENE", Severity::info, report,
                                "the file has no scene, which would say what belongs together: " +
                                    counted(count, "node with a mesh was", "nodes with a mesh were") + " read",
                                count));
    }
    if (const std::uint64_t count = scene.unread.nodes; count > 0) {
        findings.push_back(told("FILE_NODES_UNREAD", Severity::warning, report,
                                counted(count, "node with a mesh is", "nodes with a mesh are") +
                                    " outside the scene that is read (of another scene, or a level of detail)",
                                count));
    }
}

void judge_poses(const Scene& scene, const FileReport& report, std::vector<Finding>& findings) {
    if (const std::uint64_t count = scene.unread.skins; count > 0) {
        findings.push_back(told("FILE_SKIN", Severity::warning, report,
                                counted(count, "mesh is", "meshes are") +
                                    " bound to a skeleton, which is not read: vertices are where they were before it "
                                    "moved them; apply the armature before exporting if it poses the surface",
                                count));
    }
    if (const std::uint64_t count = scene.unread.morphs; count > 0) {
        findings.push_back(told("FILE_MORPH", Severity::warning, report,
                                counted(count, "mesh or node mixes", "meshes and nodes mix") +
                                    " in morph targets (shape keys), which are not read; apply them before exporting",
                                count));
    }
}

void judge_extensions(const Scene& scene, const FileReport& report, std::vector<Finding>& findings) {
    if (scene.extensions.empty()) return;
    std::string names;
    for (std::size_t i = 0; i < std::min(scene.extensions.size(), max_places); ++i)
        names += (i == 0 ? "" : ", ") + scene.extensions[i];
    if (scene.extensions.size() > max_places) names += ", ...";
    findings.push_back(told("FILE_EXTENSION", Severity::info, report,
                            "the file requires " + names + ": not read, the surface does not need it",
                            scene.extensions.size()));
}

}

std::vector<Finding> judge_reading(const Scene& scene, const FileReport& report) {
    std::vector<Finding> findings;
    judge_faces(scene, report, findings);
    judge_nodes(scene, report, findings);
    judge_poses(scene, report, findings);
    judge_extensions(scene, report, findings);
    if (const std::uint64_t count = scene.unread.free_form; count > 0) {
        findings.push_back(told("FILE_FREE_FORM", Severity::warning, report,
                                counted(count, "free-form curve or surface was", "free-form curves and surfaces were") +
                                    " not read; convert to polygons what belongs to the surface",
                                count));
    }
    if (const std::uint64_t count = scene.unread.bytes; count > 0) {
        findings.push_back(told("FILE_UNREAD", Severity::warning, report,
                                counted(count, "byte follows", "bytes follow") + " what the header announces and " +
                                    (count == 1 ? "was" : "were") + " not read; is what the header says too small?",
                                count));
    }
    if (const std::uint64_t count = report.points_and_lines; count > 0) {
        findings.push_back(told("FILE_POINTS_AND_LINES", Severity::info, report,
                                counted(count, "point or line was", "points and lines were") + " dropped", count));
    }
    return findings;
}

std::vector<Finding> judge_other_paint(const formats::Unread& unread, std::size_t color_set_count) {
    std::vector<Finding> findings;
    if (color_set_count > 0) return findings;
    if (unread.colored_faces > 0) {
        findings.push_back(
            {"COLOR_ON_FACES",
             Severity::warning,
             counted(unread.colored_faces, "face has a colour of its own", "faces have colours of their own") +
                 ", which is no lock: only colours of vertices are read; paint vertices (in Blender a colour "
                 "attribute of the domain Vertex, in MeshLab Transfer Color: Face to Vertex)",
             unread.colored_faces,
             {}});
    }
    if (unread.polypaint > 0) {
        findings.push_back(
            {"COLOR_IN_COMMENTS",
             Severity::warning,
             "ZBrush's polypaint of " + counted(unread.polypaint, "vertex", "vertices") +
                 " stands in comments (#MRGB), which are not read and lock nothing; export PLY or FBX with "
                 "vertex colours",
             unread.polypaint,
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
