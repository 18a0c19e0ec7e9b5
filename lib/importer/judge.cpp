// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/judge.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/counted.h"
#include "core/error.h"
#include "core/short_text.h"
#include "formats/color.h"
#include "geometry/measures.h"
#include "geometry/predicates.h"
#include "geometry/self_intersection.h"

namespace crumple::importer {

namespace {

// A coordinate this many times the box diagonal keeps 24 - 13 = 11 bits for the shape: details of 1/2000 are lost.
constexpr double far_away = 1e4;

constexpr double hopelessly_far = 1e6;

// Nobody simulates more, and every stage after import would take minutes.
constexpr std::size_t most_triangles = 1'000'000;

// Metres across that a simulated object rarely has.
constexpr double smallest_usual = 0.01;
constexpr double largest_usual = 100;

struct Unit {
    double metres;
    const char* name;
};
constexpr Unit usual_units[] = {{1, "metres"}, {0.01, "centimetres"}, {0.001, "millimetres"}, {0.0254, "inches"}};

// More than this share locked is rarely meant: black is a common default fill.
constexpr double nearly_all = 0.95;

// Exact: whether no four vertices span a tet.
bool is_flat(const std::vector<Vec3>& p) {
    std::size_t second = 1;
    while (second < p.size() && p[second] == p[0]) ++second;
    std::size_t third = second + 1;
    while (third < p.size() && are_collinear(p[0], p[second], p[third])) ++third;
    for (std::size_t v = third + 1; v < p.size(); ++v) {
        if (orient3d(p[0], p[second], p[third], p[v]) != 0) return false;
    }
    return true;
}

struct FarthestVertex {
    Vec3 place;
    double distance = 0;  // from the origin
};

FarthestVertex farthest_vertex(const Shell& shell) {
    FarthestVertex farthest;
    for (const Vec3& p : shell.positions) {
        if (length(p) > farthest.distance) farthest = {p, length(p)};
    }
    return farthest;
}

std::string shortest(double value) { return short_text(value, 4); }

std::string percent(double share) { return std::to_string(static_cast<int>(std::floor(100 * share))) + " %"; }

// Where each of the first components is.
std::vector<Place> places_of_components(const Shell& shell) {
    std::vector<Place> places;
    std::vector<bool> seen(shell.components.size(), false);
    for (std::size_t t = 0; t < shell.triangles.size() && places.size() < max_places; ++t) {
        const Index c = shell.component[t];
        if (seen[c]) continue;
        seen[c] = true;
        places.push_back({shell.positions[shell.triangles[t][0]], shell.triangles[t][0], shell.components[c].name});
    }
    return places;
}

Finding nothing_painted(const Shell& shell, const PaintedVertices& painted, const Params& params) {
    const std::string set = std::to_string(params.color_set);
    const bool has_colors =
        std::any_of(painted.paint.begin(), painted.paint.end(), [](Paint p) { return p != Paint::none; });
    const std::string why = painted.set_count == 0 ? "the file has no vertex colours"
                            : !has_colors          ? "the file has no colour set " + set
                                                   : "no vertex has red 0 in colour set " + set;
    return {"LOCK_NOTHING_PAINTED", Severity::warning, why + ": nothing is locked", shell.positions.size(),
            places_of_components(shell)};
}

Finding nearly_all_painted(const Shell& shell, std::uint64_t locked, double share) {
    return {"LOCK_NEARLY_ALL", Severity::warning,
            percent(share) +
                " of the vertices are locked; black is a common default fill, paint white where the shell "
                "may deform",
            locked, places_of_components(shell)};
}

// "1 pair crosses; it ...", "7 pairs cross; it ...".
void finish(Finding& finding, std::string_view one, std::string_view many, const std::string& rest,
            std::vector<Finding>& findings) {
    if (finding.count == 0) return;
    finding.message = counted(finding.count, one, many) + rest;
    findings.push_back(finding);
}

}

void check_triangle_count(std::size_t count) {
    if (count <= most_triangles) return;
    throw Error(ErrorKind::bad_input, "SHELL_TOO_LARGE: " + std::to_string(count) + " triangles, at most " +
                                          std::to_string(most_triangles) + "; a control shell is coarse, decimate it");
}

void check_usable(const Shell& shell, std::uint64_t file_triangles, double unit, bool is_caged) {
    if (shell.triangles.empty()) {
        throw Error(ErrorKind::bad_input, file_triangles == 0
                                              ? "SHELL_EMPTY: it has no faces; a control shell is a closed surface"
                                              : "SHELL_EMPTY: none of its " + std::to_string(file_triangles) +
                                                    " triangles has an area, read at " + shortest(unit) +
                                                    " m a unit of the file");
    }
    const double diagonal = bounding_box(shell.positions).diagonal();
    if (!(farthest_vertex(shell).distance <= hopelessly_far * diagonal)) {
        throw Error(ErrorKind::bad_input,
                    "SHELL_FAR_FROM_ORIGIN: the shell lies more than a million times its size from the origin, where "
                    "floats cannot tell its vertices apart; move it to the origin before exporting");
    }
    if (!is_caged && is_flat(shell.positions)) {
        throw Error(ErrorKind::bad_input,
                    "SHELL_FLAT: all its vertices lie in one plane; a control shell encloses a volume (import.thicken "
                    "gives a single sheet a "
                    "thickness)");
    }
}

std::vector<Finding> judge_shape(const Shell& shell, const Context& context, std::uint64_t& intersections) {
    Finding crossing{"SHELL_SELF_INTERSECTING", Severity::warning, "", 0, {}};
    Finding overlapping{"SHELL_OVERLAPPING", Severity::warning, "", 0, {}};
    Finding hollow{"SHELL_NO_VOLUME", Severity::warning, "", 0, {}};
    const auto pairs = self_intersections(shell.positions, shell.triangles, context);
    intersections = pairs.size();
    for (const MeetingTriangles& pair : pairs) {
        const Index first = shell.component[pair.first];
        const Index second = shell.component[pair.second];
        Finding& finding = first == second ? crossing : overlapping;
        const std::string name =
            shell.components[first].name + (first == second ? "" : " / " + shell.components[second].name);
        count_one(finding, {pair.place, pair.first, name});
    }
    for (std::size_t c = 0; c < shell.components.size(); ++c) {
        const Component& component = shell.components[c];
        if (!component.is_closed || component.volume > 0) continue;
        ++hollow.count;
        if (!wants_place(hollow)) continue;
        const auto first =
            std::find(shell.component.begin(), shell.component.end(), static_cast<Index>(c)) - shell.component.begin();
        hollow.places.push_back(
            {shell.positions[shell.triangles[static_cast<std::size_t>(first)][0]], none, component.name});
    }
    std::vector<Finding> findings;
    finish(crossing, "pair of triangles of one component crosses or touches",
           "pairs of triangles of one component cross or touch",
           "; the winding number decides there, which counts what is enclosed twice as inside", findings);
    finish(overlapping, "pair of triangles of two components crosses or touches",
           "pairs of triangles of two components cross or touch", "; where they overlap the smaller one decides",
           findings);
    finish(hollow, "closed component encloses", "closed components enclose",
           " nothing (front and back coincide); export single-sided surfaces", findings);
    return findings;
}

std::vector<Finding> judge_unused_locks(const Scene& scene, const std::vector<Vec3>& vertex_list,
                                        const std::vector<std::uint8_t>& is_used) {
    Finding finding{"LOCK_UNUSED", Severity::warning, "", 0, {}};
    for (std::size_t v = 0; v < scene.file_reds.size(); ++v) {
        if (is_used[v] || !formats::is_locked(scene.file_reds[v])) continue;
        count_one(finding, {vertex_list[v], static_cast<Index>(v), ""});
    }
    std::vector<Finding> findings;
    finish(finding, "locked vertex belongs to no face and was", "locked vertices belong to no face and were",
           " dropped", findings);
    return findings;
}

std::vector<Finding> judge_size(double diagonal, const Placement& placement) {
    if (!(diagonal > 0) || (diagonal >= smallest_usual && diagonal <= largest_usual)) return {};
    std::string message = "the shell's diagonal is " + shortest(diagonal) + " m, read at " + shortest(placement.unit) +
                          " m a unit of the file";
    for (const auto& [unit, name] : usual_units) {
        const double meant = diagonal / placement.unit * unit;
        if (unit == placement.unit || meant < 0.1 || meant > 50) continue;
        message += "; if the file is in " + std::string(name) + ", --unit " + shortest(unit) + " makes it " +
                   shortest(meant) + " m";
    }
    return {{"IMPORT_SIZE_UNUSUAL", Severity::warning, message, 1, {}}};
}

std::vector<Finding> judge_precision(const Shell& shell, double diagonal) {
    Finding finding{"SHELL_FAR_FROM_ORIGIN", Severity::warning, "", 1, {}};
    const auto [place, farthest] = farthest_vertex(shell);
    if (!(farthest > far_away * diagonal)) return {};
    finding.places = {{place, none, ""}};
    finding.message = "the shell lies " +
                      std::to_string(static_cast<std::uint64_t>(std::min(farthest / diagonal, 1e18))) +
                      " times its size from the origin: float positions have lost precision there, vertices may have "
                      "merged; move it to the origin before exporting";
    return {finding};
}

std::vector<Finding> judge_locks(const Shell& shell, const PaintedVertices& painted, Finding conflicts,
                                 const Params& params) {
    std::vector<Finding> findings = painted.findings;
    const auto locked = static_cast<std::uint64_t>(std::count(shell.locked.begin(), shell.locked.end(), 1));
    const double share = static_cast<double>(locked) / static_cast<double>(shell.locked.size());
    if (locked == 0) findings.push_back(nothing_painted(shell, painted, params));
    if (share > nearly_all) findings.push_back(nearly_all_painted(shell, locked, share));
    finish(conflicts, "locked vertex has a copy painted free (a seam between materials, say); it is",
           "locked vertices have a copy painted free (a seam between materials, say); they are",
           " locked; paint all copies alike", findings);
    if (params.strict && conflicts.count > 0) {
        throw Error(ErrorKind::bad_input, "LOCK_CONFLICT: " + findings.back().message + " (first: source vertex " +
                                              std::to_string(findings.back().places.front().element) +
                                              "); import.strict makes this an error");
    }
    return findings;
}

}
