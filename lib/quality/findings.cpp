// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <string>

#include "quality/quality.h"

namespace crumple::quality {

namespace {

enum class Wanted { high, low };
enum class Kind { shape, stiffness };

// A measure beyond `notable` is told; beyond `unusable` a mesh is of no use to most solvers, which the message says.
struct Bound {
    const char* code;
    const char* what;
    double value;
    double notable;
    double unusable;
    Wanted wanted;
    Kind kind;
};

constexpr const char* shape_remedy =
    "try more interior points, more relax sweeps, or a shell with better triangles there";
constexpr const char* stiffness_remedy = "look for short edges and thin places of the shell";

bool is_beyond(const Bound& bound, double limit) {
    return bound.wanted == Wanted::high ? bound.value < limit : bound.value > limit;
}

std::string message_of(const Bound& bound) {
    const bool is_unusable = is_beyond(bound, bound.unusable);
    char text[400];
    std::snprintf(text, sizeof text, "%s is %.4g, %s %.4g%s; %s", bound.what, bound.value,
                  bound.wanted == Wanted::high ? "below" : "above", is_unusable ? bound.unusable : bound.notable,
                  is_unusable ? ", too bad for most solvers" : "",
                  bound.kind == Kind::stiffness ? stiffness_remedy : shape_remedy);
    return text;
}

std::vector<Bound> bounds_of(const Summary& s) {
    const double below_10_percent = 100.0 * s.below_10_deg / s.tets;
    return {
        {"QUALITY_MIN_DIHEDRAL", "the smallest dihedral angle (degrees)", s.min_dihedral_deg, 5, 1, Wanted::high,
         Kind::shape},
        {"QUALITY_MAX_DIHEDRAL", "the largest dihedral angle (degrees)", s.max_dihedral_deg, 170, 179, Wanted::low,
         Kind::shape},
        {"QUALITY_BELOW_10_DEG", "the share of tets with an angle below 10 degrees (%)", below_10_percent, 0.5, 5,
         Wanted::low, Kind::shape},
        {"QUALITY_P5_DIHEDRAL", "the 5th percentile of the tets' smallest angles (degrees)", s.p5_dihedral_deg, 12, 5,
         Wanted::high, Kind::shape},
        {"QUALITY_FLAT_TET", "the least volume / (mean edge)^3, 1 for a regular tet,", s.volume_lrms3_min, 0.02, 1e-3,
         Wanted::high, Kind::shape},
        {"QUALITY_RADIUS_RATIO", "the least radius ratio, 1 for a regular tet,", s.radius_ratio_min, 0.01, 1e-3,
         Wanted::high, Kind::shape},
        {"QUALITY_ELEMENT_STEP", "the smallest element's time step over a regular tet's", s.element_step_ratio, 0.1,
         0.01, Wanted::high, Kind::stiffness},
        {"QUALITY_STIFFNESS_RATIO", "the stiffest element over the median one", s.stiffness_ratio, 500, 1e4,
         Wanted::low, Kind::stiffness},
    };
}

std::vector<Place> inverted_places(const TetMesh& mesh) {
    std::vector<Place> places = worst_tets(mesh.positions, mesh.tets);
    std::erase_if(places, [&](const Place& place) {
        const auto& [a, b, c, d] = mesh.tets[place.element];
        return measure_tet(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]).volume > 0;
    });
    return places;
}

}

// Bounds: the warn and fail columns of the quality study the project's goals come from. They are warnings here; a gate
// that refuses a mesh belongs to whoever asks for one.
std::vector<Finding> find_problems(const TetMesh& mesh, const Summary& summary) {
    std::vector<Finding> findings;
    if (summary.tets == 0) return findings;
    if (summary.inverted > 0) {
        findings.push_back({"QUALITY_INVERTED", Severity::warning, "tets without volume or turned inside out",
                            summary.inverted, inverted_places(mesh)});
    }
    for (const Bound& bound : bounds_of(summary)) {
        if (!is_beyond(bound, bound.notable)) continue;
        const auto find_worst = bound.kind == Kind::stiffness ? stiffest_tets : worst_tets;
        findings.push_back(
            {bound.code, Severity::warning, message_of(bound), 1, find_worst(mesh.positions, mesh.tets, max_places)});
    }
    return findings;
}

}
