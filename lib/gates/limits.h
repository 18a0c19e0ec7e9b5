// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh must be to be used: for every figure a limit at which it fails and one at which it is warned of.
#pragma once
#include "core/fields.h"

namespace crumple::gates {

inline constexpr double never = 1e9;  // a limit that no figure goes beyond

// No figure is negative: a limit of 0 switches one off that is a lower limit, `never` one that is an upper limit.
struct Gate {
    double fail = 0;
    double warn = 0;
};

template <class Visitor, FieldsOf<Gate> G>
void describe(Visitor& visit, G& g) {
    visit.field("fail", g.fail, Range{0, never}, "beyond this the mesh is refused");
    visit.field("warn", g.warn, Range{0, never}, "beyond this it is warned of");
}

// Where a figure is wanted: above the limits of its gate, or below them. The limit itself is allowed.
enum class Wanted { high, low };
[[nodiscard]] constexpr bool is_beyond(double value, double limit, Wanted wanted) {
    return wanted == Wanted::high ? value < limit : value > limit;
}

// Lower limits for angles, ratios and steps, upper ones for the rest.
struct Limits {
    Gate min_dihedral_deg{1, 5};
    Gate max_dihedral_deg{179, 170};
    Gate below_10_share{0.05, 0.005};
    Gate p5_dihedral_deg{5, 12};
    Gate volume_lrms3{1e-3, 0.02};
    Gate radius_ratio{1e-3, 0.01};
    Gate dt_ratio{0.01, 0.1};
    Gate stiffness_ratio{1e4, 500};
    Gate volume_error{0.05, 0.01};
    Gate hausdorff{0.05, 0.015};
    Gate non_manifold{never, 0};
    Gate extra_pieces{0, 0};
    Gate leak_share{0.1, 0.02};
    Gate outside_share{never, 0.01};
    Gate max_weight{never, 1.5};
    Gate bound_wrongly{never, 0};
    Gate pcg_growth{1.5, 1.15};
    Gate tets_growth{never, 1.25};
    Gate volume_change{0.05, 0.01};
};

template <class Visitor, FieldsOf<Limits> P>
void describe(Visitor& visit, P& p) {
    visit.field("min_dihedral_deg", p.min_dihedral_deg, "least smallest dihedral angle");
    visit.field("max_dihedral_deg", p.max_dihedral_deg, "largest dihedral angle");
    visit.field("below_10_share", p.below_10_share,
                "largest share of tets with an angle below 10 degrees, those not counted where the shell is too thin");
    visit.field("p5_dihedral_deg", p.p5_dihedral_deg, "least 5th percentile of the tets' smallest angles");
    visit.field("volume_lrms3", p.volume_lrms3, "least volume / (mean edge)^3, 1 for a regular tet");
    visit.field("radius_ratio", p.radius_ratio, "least inscribed over circumscribed radius, 1 for a regular tet");
    visit.field("dt_ratio", p.dt_ratio, "least explicit step over a regular tet's");
    visit.field("stiffness_ratio", p.stiffness_ratio, "largest ratio of the stiffest element to the median one");
    visit.field("volume_error", p.volume_error, "largest share of the solid's volume gained or lost");
    visit.field("hausdorff", p.hausdorff, "farthest the surfaces stray, share of the diagonal; closed shells only");
    visit.field("non_manifold", p.non_manifold, "most non-manifold edges and nodes of the surface");
    visit.field("extra_pieces", p.extra_pieces, "most pieces of tets beyond those of the shell");
    visit.field("leak_share", p.leak_share, "largest volume share where an open shell leaves inside undecided");
    visit.field("outside_share", p.outside_share, "largest share of visual vertices outside every tet of their shell");
    visit.field("max_weight", p.max_weight, "largest |weight| of a visual vertex");
    visit.field("bound_wrongly", p.bound_wrongly, "most visual vertices on a tet of another shell without need");
    visit.field("pcg_growth", p.pcg_growth, "most iterations of the implicit steps, times those of the baseline");
    visit.field("tets_growth", p.tets_growth, "most tets, times those of the baseline");
    visit.field("volume_change", p.volume_change, "largest change of the volume since the baseline, share of it");
}

}
