// SPDX-License-Identifier: GPL-3.0-or-later
#include "gates/shape_problems.h"

#include <cstdio>
#include <string>

#include "gates/limits.h"
#include "quality/quality.h"

namespace crumple::gates {

namespace {

enum class Kind { shape, stiffness };

// A figure beyond the warning limit of its gate is told; beyond the other a mesh is of no use to most solvers, which
// the message says.
struct Bound {
    const char* code;
    const char* what;
    double value;
    Gate limits;
    Wanted wanted;
    Kind kind;
};

constexpr const char* shape_remedy =
    "try more interior points, more relax sweeps, or a shell with better triangles there";
constexpr const char* stiffness_remedy = "look for short edges and thin places of the shell";

std::string message_of(const Bound& bound) {
    const bool is_unusable = is_beyond(bound.value, bound.limits.fail, bound.wanted);
    char text[400];
    std::snprintf(text, sizeof text, "%s is %.4g, %s %.4g%s; %s", bound.what, bound.value,
                  bound.wanted == Wanted::high ? "below" : "above", is_unusable ? bound.limits.fail : bound.limits.warn,
                  is_unusable ? ", too bad for most solvers" : "",
                  bound.kind == Kind::stiffness ? stiffness_remedy : shape_remedy);
    return text;
}

std::vector<Bound> bounds_of(const quality::Summary& s) {
    const Limits gates;
    const double percent = 100;
    const Gate below_10_percent{percent * gates.below_10_share.fail, percent * gates.below_10_share.warn};
    return {
        {"QUALITY_MIN_DIHEDRAL", "the smallest dihedral angle (degrees)", s.min_dihedral_deg, gates.min_dihedral_deg,
         Wanted::high, Kind::shape},
        {"QUALITY_MAX_DIHEDRAL", "the largest dihedral angle (degrees)", s.max_dihedral_deg, gates.max_dihedral_deg,
         Wanted::low, Kind::shape},
        {"QUALITY_BELOW_10_DEG", "the share of tets with an angle below 10 degrees (%)",
         percent * s.below_10_deg / s.tets, below_10_percent, Wanted::low, Kind::shape},
        {"QUALITY_P5_DIHEDRAL", "the 5th percentile of the tets' smallest angles (degrees)", s.p5_dihedral_deg,
         gates.p5_dihedral_deg, Wanted::high, Kind::shape},
        {"QUALITY_FLAT_TET", "the least volume / (mean edge)^3, 1 for a regular tet,", s.volume_lrms3_min,
         gates.volume_lrms3, Wanted::high, Kind::shape},
        {"QUALITY_RADIUS_RATIO", "the least radius ratio, 1 for a regular tet,", s.radius_ratio_min, gates.radius_ratio,
         Wanted::high, Kind::shape},
        // The least an element allows is below what the whole mesh does, never above.
        {"QUALITY_ELEMENT_STEP", "the smallest element's time step over a regular tet's", s.element_step_ratio,
         gates.dt_ratio, Wanted::high, Kind::stiffness},
        {"QUALITY_STIFFNESS_RATIO", "the stiffest element over the median one", s.stiffness_ratio,
         gates.stiffness_ratio, Wanted::low, Kind::stiffness},
    };
}

std::vector<Place> inverted_places(const TetMesh& mesh) {
    std::vector<Place> places = quality::worst_tets(mesh.positions, mesh.tets);
    std::erase_if(places, [&](const Place& place) {
        const auto& [a, b, c, d] = mesh.tets[place.element];
        return quality::measure_tet(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[d]).volume >
               0;
    });
    return places;
}

}

// Held against the gates' own defaults, but nothing is refused here: a gate belongs to whoever asks for one.
std::vector<Finding> find_problems(const TetMesh& mesh, const quality::Summary& summary) {
    std::vector<Finding> findings;
    if (summary.tets == 0) return findings;
    if (summary.inverted > 0) {
        findings.push_back({"QUALITY_INVERTED", Severity::warning, "tets without volume or turned inside out",
                            summary.inverted, inverted_places(mesh)});
    }
    for (const Bound& bound : bounds_of(summary)) {
        if (!is_beyond(bound.value, bound.limits.warn, bound.wanted)) continue;
        const auto find_worst = bound.kind == Kind::stiffness ? quality::stiffest_tets : quality::worst_tets;
        findings.push_back(
            {bound.code, Severity::warning, message_of(bound), 1, find_worst(mesh.positions, mesh.tets, max_places)});
    }
    return findings;
}

}
