// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/thin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/counted.h"
#include "core/parallel_for.h"
#include "core/short_text.h"
#include "geometry/bvh.h"
#include "geometry/measures.h"

namespace crumple::sample {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Below this ratio the smallest angle is below 5.7 degrees.
constexpr double too_thin = 0.1;

using Corners = std::array<Vec3, 3>;

Corners corners_of(const Shell& shell, Index t) {
    const auto& [a, b, c] = shell.triangles[t];
    return {shell.positions[a], shell.positions[b], shell.positions[c]};
}

double mean_edge(const Corners& t) { return (length(t[1] - t[0]) + length(t[2] - t[1]) + length(t[0] - t[2])) / 3; }

// How far along the ray the triangle is, infinity where it misses [Moeller and Trumbore 1997].
double hit(const Corners& t, Vec3 from, Vec3 along) {
    const Vec3 to_b = t[1] - t[0];
    const Vec3 to_c = t[2] - t[0];
    const Vec3 p = cross(along, to_c);
    const double determinant = dot(to_b, p);
    if (determinant == 0) return infinity;
    const Vec3 s = from - t[0];
    const double u = dot(s, p) / determinant;
    const Vec3 q = cross(s, to_b);
    const double v = dot(along, q) / determinant;
    const double distance = dot(to_c, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && distance > 0 ? distance : infinity;
}

struct Measured {
    double area = 0;
    double edge = 0;
    double thickness = infinity;  // infinity: not thin
};

// Triangles face away from material, those of cavities too: the other side is straight behind.
Measured measure(const Shell& shell, const Bvh& tree, Index t, double clearance) {
    const Corners corners = corners_of(shell, t);
    const Vec3 normal = area_vector(corners[0], corners[1], corners[2]);
    const double size = length(normal);
    Measured measured{size / 2, mean_edge(corners), infinity};
    if (!(size > 0)) return measured;
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const Vec3 along = normal / -size;
    const double farthest = 2 * clearance * measured.edge;
    Box reach;
    reach.add(middle);
    reach.add(middle + along * farthest);
    tree.touching(reach, [&](Index other) {
        if (other != t) measured.thickness = std::min(measured.thickness, hit(corners_of(shell, other), middle, along));
        return false;
    });
    if (measured.thickness > farthest) measured.thickness = infinity;
    return measured;
}

Place place_of(const Shell& shell, Index t) {
    const Corners corners = corners_of(shell, t);
    return {(corners[0] + corners[1] + corners[2]) / 3.0, t, shell.components[shell.component[t]].name};
}

}

ThinParts find_thin_parts(const Shell& shell, double clearance, const Context& context) {
    std::vector<Box> boxes;
    for (Index t = 0; t < shell.triangles.size(); ++t) boxes.push_back(bounding_box(corners_of(shell, t)));
    const Bvh tree(boxes);
    std::vector<Measured> measured(shell.triangles.size());
    parallel_for(context, measured.size(), 256, [&](std::size_t begin, std::size_t end) {
        context.stop_if_cancelled();
        for (std::size_t t = begin; t < end; ++t) {
            const bool is_rigid = shell.components[shell.component[t]].role == Role::rigid;
            if (!is_rigid) measured[t] = measure(shell, tree, static_cast<Index>(t), clearance);
        }
    });
    ThinParts thin;
    double whole = 0;
    std::vector<Index> order;
    for (Index t = 0; t < measured.size(); ++t) {
        whole += measured[t].area;
        if (measured[t].thickness == infinity) continue;
        thin.area_share += measured[t].area;
        thin.least_thickness =
            order.empty() ? measured[t].thickness : std::min(thin.least_thickness, measured[t].thickness);
        order.push_back(t);
    }
    if (order.empty()) return thin;
    const auto ratio = [&](Index t) { return measured[t].thickness / measured[t].edge; };
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return ratio(a) < ratio(b); });
    thin.triangles = order.size();
    thin.area_share /= whole;
    thin.least_ratio = ratio(order.front());
    for (std::size_t i = 0; i < std::min<std::size_t>(order.size(), max_places); ++i)
        thin.thinnest.push_back(place_of(shell, order[i]));
    return thin;
}

std::vector<Finding> describe_thin_parts(const ThinParts& thin) {
    if (thin.triangles == 0) return {};
    const double angle = std::atan(thin.least_ratio) * 180 / std::numbers::pi;
    const std::string text = counted(thin.triangles, "triangle", "triangles") + " (" + percent_text(thin.area_share) +
                             " of the surface) " + (thin.triangles == 1 ? "lies" : "lie") +
                             " where the shell is thin against the edges: one layer of tets fits there. The thinnest "
                             "place is " +
                             short_text(thin.least_thickness) + " m, " + short_text(thin.least_ratio, 2) +
                             " of an edge: no angle there is above " + short_text(angle, 2) +
                             " degrees; use shorter edges there, or accept it";
    const Severity severity = thin.least_ratio < too_thin ? Severity::warning : Severity::info;
    return {{"SAMPLE_THIN", severity, text, thin.triangles, thin.thinnest}};
}

}
