// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/place_teller.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/short_text.h"
#include "geometry/boundary_loops.h"
#include "geometry/measures.h"
#include "quality/element_stiffness.h"
#include "quality/tet_measures.h"
#include "quality/worst_tets.h"

namespace crumple::quality {

namespace {

// Gates ask for angles up to about this; what the shell forces is told up to there.
constexpr double explained_below_deg = 20;

// Lower is worse.
double value_of(Badness badness, const std::array<Vec3, 4>& at) {
    const auto& [a, b, c, d] = at;
    switch (badness) {
        case Badness::flattest:
            return min_dihedral_key(a, b, c, d);
        case Badness::widest:
            return -measure_tet(a, b, c, d).max_dihedral;
        case Badness::least_volume:
            return measure_tet(a, b, c, d).volume_lrms3;
        case Badness::least_radius:
            return measure_tet(a, b, c, d).radius_ratio;
        case Badness::least_step:
            return measure_stiffness(a, b, c, d).step;
        case Badness::stiffest:
            return -measure_stiffness(a, b, c, d).largest;
    }
    return 0;
}

std::string figure_of(Badness badness, double value) {
    char text[48];
    switch (badness) {
        case Badness::flattest:
            std::snprintf(text, sizeof text, "%.3g degrees", degrees_of(value));
            break;
        case Badness::widest:
            std::snprintf(text, sizeof text, "%.4g degrees", degrees_of(-value));
            break;
        case Badness::least_volume:
            std::snprintf(text, sizeof text, "volume / edge^3 %.3g", value);
            break;
        case Badness::least_radius:
            std::snprintf(text, sizeof text, "radius ratio %.3g", value);
            break;
        case Badness::least_step:
            std::snprintf(text, sizeof text, "step %.3g m", value);
            break;
        case Badness::stiffest:
            std::snprintf(text, sizeof text, "stiffness %.3g m", -value);
            break;
    }
    return text;
}

const char* text_of(ShellLimit limit) {
    switch (limit) {
        case ShellLimit::none:
            return "";
        case ShellLimit::thin:
            return "forced by a thin shell";
        case ShellLimit::needle:
            return "forced by a needle of the shell";
        case ShellLimit::gap:
            return "forced by a narrow gap of the shell";
    }
    return "";
}

void append(std::string& text, const std::string& part) {
    if (part.empty()) return;
    if (!text.empty()) text += ", ";
    text += part;
}

std::string nearest_painted(std::span<const Vec3> painted, Vec3 p) {
    if (painted.empty()) return {};
    const auto distance_2 = [&](Vec3 q) { return dot(q - p, q - p); };
    Vec3 nearest = painted.front();
    for (const Vec3 q : painted) {
        if (distance_2(q) < distance_2(nearest)) nearest = q;
    }
    char text[120];
    std::snprintf(text, sizeof text, "%.3g m from the painted vertex at (%.4g %.4g %.4g)", length(nearest - p),
                  nearest.x, nearest.y, nearest.z);
    return text;
}

std::array<Vec3, 4> corners_of(const TetMesh& mesh, const Tet& tet) {
    std::array<Vec3, 4> at;
    for (int i = 0; i < 4; ++i) at[i] = mesh.positions[tet[i]];
    return at;
}

}

std::string PlaceTeller::tell(Vec3 position, Index tet, const std::string& figure) const {
    std::string text = figure;
    if (tet < mesh_.region.size() && mesh_.region[tet] < names_.components.size()) {
        append(text, names_.components[mesh_.region[tet]]);
    }
    if (tet < names_.tet_material.size() && names_.tet_material[tet] < names_.materials.size()) {
        append(text, names_.materials[names_.tet_material[tet]]);
    }
    append(text, nearest_painted(names_.painted, position));
    return text;
}

Place PlaceTeller::at_tet(Index tet, const std::string& figure) const {
    const Vec3 centre = centre_of(mesh_.positions, mesh_.tets[tet]);
    return {centre, tet, tell(centre, tet, figure)};
}

Place PlaceTeller::at_node(Index node) const {
    const auto tet = std::find_if(mesh_.tets.begin(), mesh_.tets.end(), [&](const Tet& corners) {
        return std::find(corners.begin(), corners.end(), node) != corners.end();
    });
    const auto index = tet == mesh_.tets.end() ? none : static_cast<Index>(tet - mesh_.tets.begin());
    return {mesh_.positions[node], node, tell(mesh_.positions[node], index, {})};
}

Place PlaceTeller::at(Vec3 position, const std::string& figure) const {
    Index nearest = none;
    double least_2 = 0;
    for (Index t = 0; t < mesh_.tets.size(); ++t) {
        const Vec3 away = centre_of(mesh_.positions, mesh_.tets[t]) - position;
        if (nearest != none && dot(away, away) >= least_2) continue;
        nearest = t;
        least_2 = dot(away, away);
    }
    return {position, none, tell(position, nearest, figure)};
}

Place PlaceTeller::at_vertex(const HungVertex& vertex) const {
    const auto& [position, element, name] = vertex.place;
    return {position, element, tell(position, vertex.tet, name)};
}

std::vector<Place> PlaceTeller::holes() const {
    std::vector<Box> boxes;
    for (const std::vector<Index>& loop : boundary_loops(surface_.triangles)) {
        Box& box = boxes.emplace_back();
        for (const Index v : loop) box.add(surface_.positions[v]);
    }
    std::stable_sort(boxes.begin(), boxes.end(),
                     [](const Box& a, const Box& b) { return a.diagonal() > b.diagonal(); });
    std::vector<Place> places;
    for (std::size_t i = 0; i < boxes.size() && i < max_places; ++i) {
        const Vec3 middle = (boxes[i].low + boxes[i].high) * 0.5;
        places.push_back(at(middle, "a hole " + short_text(boxes[i].diagonal()) + " m across"));
    }
    return places;
}

PlaceTeller::Worst PlaceTeller::worst(Badness badness, ShellLimit skipped) const {
    std::vector<double> values;
    values.reserve(mesh_.tets.size());
    for (const Tet& tet : mesh_.tets) values.push_back(value_of(badness, corners_of(mesh_, tet)));
    // Enough to choose from where some are left out.
    const std::size_t count = skipped == ShellLimit::none ? max_places : 16 * max_places;
    const std::vector<Index> order = least_tets(mesh_.positions, mesh_.tets, values, count);
    std::vector<Tet> tets;
    for (const Index t : order) tets.push_back(mesh_.tets[t]);
    const std::vector<ShellLimit> limits = find_limits(surface_, mesh_.positions, tets, {}, explained_below_deg);
    Worst worst;
    for (std::size_t i = 0; i < order.size() && worst.places.size() < max_places; ++i) {
        if (skipped != ShellLimit::none && limits[i] == skipped) continue;
        if (worst.places.empty()) {
            worst.limit = limits[i];
            worst.is_flat = value_of(Badness::flattest, corners_of(mesh_, mesh_.tets[order[i]])) < key_of_10_deg;
        }
        std::string figure = figure_of(badness, values[order[i]]);
        append(figure, text_of(limits[i]));
        worst.places.push_back(at_tet(order[i], figure));
    }
    return worst;
}

std::uint64_t PlaceTeller::count(ShellLimit limit) const {
    const std::vector<ShellLimit> limits = find_limits(surface_, mesh_.positions, mesh_.tets);
    return static_cast<std::uint64_t>(std::count(limits.begin(), limits.end(), limit));
}

}
