// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/flaws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "core/counted.h"
#include "core/disjoint_sets.h"
#include "core/short_text.h"
#include "geometry/bvh.h"
#include "geometry/measures.h"
#include "importer/edges.h"

namespace crumple::importer {

namespace {

constexpr double needle_sine_2 = 0.0075961;  // of 5 degrees, squared

// Two diagonals of float rounding: what an exporter may have moved a vertex that was meant to lie on an edge.
constexpr double on_edge = 1e-6;

// Diagonals between two surfaces of which one may be a copy: at five metres 0.05 mm, thinner than any sheet.
constexpr double nearly_double = 1e-5;

struct Needle {
    double sine_2;  // of the smallest angle, squared
    Index triangle;
};

// The smallest angle lies between the two longest sides.
double smallest_sine_2(Vec3 a, Vec3 b, Vec3 c) {
    std::array<double, 3> sides_2{dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)};
    std::sort(sides_2.begin(), sides_2.end());
    const Vec3 normal = area_vector(a, b, c);
    const double sides = sides_2[1] * sides_2[2];
    return sides > 0 ? dot(normal, normal) / sides : 0;
}

Place place_of(const Shell& shell, Index t) {
    const auto& [a, b, c] = shell.triangles[t];
    return {(shell.positions[a] + shell.positions[b] + shell.positions[c]) / 3.0, t,
            shell.components[shell.component[t]].name};
}

std::vector<Finding> find_needles(const Shell& shell) {
    std::vector<Needle> needles;
    for (Index t = 0; t < shell.triangles.size(); ++t) {
        const auto& [a, b, c] = shell.triangles[t];
        const double sine_2 = smallest_sine_2(shell.positions[a], shell.positions[b], shell.positions[c]);
        if (sine_2 < needle_sine_2) needles.push_back({sine_2, t});
    }
    if (needles.empty()) return {};
    std::stable_sort(needles.begin(), needles.end(),
                     [](const Needle& a, const Needle& b) { return a.sine_2 < b.sine_2; });
    const double sharpest = std::asin(std::sqrt(needles.front().sine_2)) * 180 / std::numbers::pi;
    const std::string text = counted(needles.size(), "triangle has", "triangles have") +
                             " a corner below 5 degrees (the sharpest " + short_text(sharpest, 2) +
                             "): elements there are hardly better; collapse short edges. Within a flat area they do "
                             "little harm";
    Finding finding{"SHELL_NEEDLE", Severity::warning, text, needles.size(), {}};
    for (std::size_t i = 0; i < std::min<std::size_t>(needles.size(), max_places); ++i)
        finding.places.push_back(place_of(shell, needles[i].triangle));
    return {finding};
}

std::vector<HalfEdge> open_edges(const Shell& shell) {
    std::vector<HalfEdge> open;
    const std::vector<HalfEdge> half_edges = sorted_half_edges(shell.triangles);
    for_each_edge(half_edges, [&](std::span<const HalfEdge> edge) {
        if (edge.size() == 1) open.push_back(edge[0]);
    });
    return open;
}

bool lies_on_middle(Vec3 a, Vec3 b, Vec3 p, double tolerance) {
    const Vec3 along = b - a;
    const double share = dot(p - a, along) / dot(along, along);
    return share > 0 && share < 1 && length(p - a) > tolerance && length(p - b) > tolerance &&
           length(a + along * share - p) <= tolerance;
}

std::vector<Finding> find_t_junctions(const Shell& shell, double diagonal) {
    const std::vector<HalfEdge> open = open_edges(shell);
    std::vector<Box> boxes;
    std::vector<Index> rim;
    for (const HalfEdge& edge : open) {
        boxes.push_back(bounding_box(std::array{shell.positions[edge.low], shell.positions[edge.high]}));
        rim.insert(rim.end(), {edge.low, edge.high});
    }
    std::sort(rim.begin(), rim.end());
    rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
    const Bvh tree(boxes);
    const double tolerance = on_edge * diagonal;
    Finding finding{"SHELL_T_JUNCTION", Severity::warning, "", 0, {}};
    for (const Index v : rim) {
        bool is_junction = false;
        tree.within(shell.positions[v], tolerance, [&](Index e) {
            is_junction = lies_on_middle(shell.positions[open[e].low], shell.positions[open[e].high],
                                         shell.positions[v], tolerance);
            return is_junction;
        });
        if (is_junction) count_one(finding, {shell.positions[v], v, ""});
    }
    if (finding.count == 0) return {};
    finding.message = counted(finding.count, "vertex lies", "vertices lie") +
                      " on the middle of an open edge: the edge looks closed and is not; split it there";
    return {finding};
}

// Unites the corners, 3 t + k, of triangles that share an edge: what is left apart at a vertex are its fans.
DisjointSets fans_of(const Shell& shell) {
    DisjointSets fans(3 * shell.triangles.size());
    const auto corner = [](const HalfEdge& edge, bool low) {
        return 3 * edge.triangle + (edge.ascends == low ? edge.side : (edge.side + 1) % 3);
    };
    const std::vector<HalfEdge> half_edges = sorted_half_edges(shell.triangles);
    for_each_component_edge(half_edges, shell.component, [&](Index, std::span<const HalfEdge> edge) {
        for (const HalfEdge& other : edge.subspan(1)) {
            fans.unite(corner(edge[0], true), corner(other, true));
            fans.unite(corner(edge[0], false), corner(other, false));
        }
    });
    return fans;
}

std::vector<Finding> find_pinched(const Shell& shell) {
    DisjointSets fans = fans_of(shell);
    std::vector<std::array<Index, 2>> fan_at;  // vertex and component of each fan
    for (Index c = 0; c < 3 * shell.triangles.size(); ++c) {
        if (fans.find(c) == c) fan_at.push_back({shell.triangles[c / 3][c % 3], shell.component[c / 3]});
    }
    std::sort(fan_at.begin(), fan_at.end());
    Finding finding{"SHELL_PINCHED", Severity::warning, "", 0, {}};
    for (auto at = fan_at.begin(); at != fan_at.end();) {
        const auto next = std::upper_bound(at, fan_at.end(), *at);
        const auto [vertex, component] = *at;
        if (next - at > 1) count_one(finding, {shell.positions[vertex], vertex, shell.components[component].name});
        at = next;
    }
    if (finding.count == 0) return {};
    finding.message = counted(finding.count, "vertex joins", "vertices join") +
                      " parts of one component that share no edge there: they hang together in a point; move them "
                      "apart, or join them over a whole face";
    return {finding};
}

struct Twin {
    Index triangle = none;
    double distance = 0;
};

// The nearest triangle that the middle of t lies on, or off along its normal. Two that face each other are solids that
// touch: nothing is between them.
Twin find_twin(const Shell& shell, const Bvh& tree, Index t, double reach) {
    const auto corners = [&](Index of) {
        const auto& [a, b, c] = shell.triangles[of];
        return std::array{shell.positions[a], shell.positions[b], shell.positions[c]};
    };
    const auto [a, b, c] = corners(t);
    const Vec3 middle = (a + b + c) / 3.0;
    const Vec3 normal = area_vector(a, b, c);
    Twin twin;
    tree.within(middle, reach, [&](Index other) {
        if (other == t || share_a_corner(shell.triangles[t], shell.triangles[other])) return false;
        const auto [p, q, r] = corners(other);
        const Vec3 off = closest_point_on_triangle(p, q, r, middle) - middle;
        const double distance = length(off);
        const Vec3 its_normal = area_vector(p, q, r);
        const bool is_beside = std::fabs(dot(off, normal)) < 0.5 * distance * length(normal);
        const bool is_across = length(cross(normal, its_normal)) > 0.1 * length(normal) * length(its_normal);
        const bool is_facing = dot(off, normal) >= 0 && dot(normal, its_normal) < 0;
        if (distance > reach || is_beside || is_across || is_facing) return false;
        const bool is_nearer = distance < twin.distance || (distance == twin.distance && other < twin.triangle);
        if (twin.triangle == none || is_nearer) twin = {other, distance};
        return false;
    });
    return twin;
}

std::vector<Finding> find_nearly_double(const Shell& shell, double diagonal) {
    const Bvh tree = tree_of(shell.positions, shell.triangles);
    Finding finding{"SHELL_NEARLY_DOUBLE", Severity::warning, "", 0, {}};
    double farthest = 0;
    for (Index t = 0; t < shell.triangles.size(); ++t) {
        const Twin twin = find_twin(shell, tree, t, nearly_double * diagonal);
        if (twin.triangle == none) continue;
        farthest = std::max(farthest, twin.distance);
        Place place = place_of(shell, t);
        const std::string& other = shell.components[shell.component[twin.triangle]].name;
        if (other != place.name) place.name += " / " + other;
        count_one(finding, std::move(place));
    }
    if (finding.count == 0) return {};
    finding.message =
        counted(finding.count, "triangle lies", "triangles lie") + " nearly on another one, at most " +
        short_text(farthest, 2) +
        " m off: a copy of a surface? No mesh between the two can be good; delete one, or move them apart";
    return {finding};
}

}

std::vector<Finding> find_flaws(const Shell& shell, double diagonal) {
    std::vector<Finding> findings = find_needles(shell);
    for (Finding& finding : find_t_junctions(shell, diagonal)) findings.push_back(std::move(finding));
    for (Finding& finding : find_pinched(shell)) findings.push_back(std::move(finding));
    for (Finding& finding : find_nearly_double(shell, diagonal)) findings.push_back(std::move(finding));
    return findings;
}

}
