// SPDX-License-Identifier: GPL-3.0-or-later
// How good the shapes of a tet mesh are, in the few numbers that predict what it costs to simulate: the smallest
// element's step and the flattest tet bound explicit steps, the low percentiles of the angles the iterations of
// implicit ones.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "core/index.h"
#include "core/vec3.h"
#include "mesh/tet_mesh.h"
#include "quality/tet_measures.h"

namespace crumple::quality {

// Of T tets. p1 and p5 are percentiles over tets of the tet's smallest dihedral angle. All 0 when there are no tets.
struct Summary {
    std::uint32_t tets = 0;
    std::uint32_t nodes = 0;     // that some tet uses
    std::uint32_t inverted = 0;  // tets of no volume or turned inside out, as floating point sees them
    double volume = 0;           // cubic metres
    double min_dihedral_deg = 0;
    double p1_dihedral_deg = 0;
    double p5_dihedral_deg = 0;
    double median_dihedral_deg = 0;
    double max_dihedral_deg = 0;  // largest of the mesh
    std::uint32_t below_10_deg = 0;
    double radius_ratio_min = 0;
    double radius_ratio_p5 = 0;
    double volume_lrms3_min = 0;
    double edge_ratio = 0;          // longest over shortest edge of the mesh
    double element_step_m = 0;      // smallest stable step of an element times the speed of sound
    double element_step_ratio = 0;  // that over the step of a regular tet of the mean volume: 1 is ideal
    double stiffness_ratio = 0;     // stiffest element over the median one
};

template <class Visitor, FieldsOf<Summary> S>
void describe(Visitor& visit, S& s) {
    visit.field("tets", s.tets, "tets measured");
    visit.field("nodes", s.nodes, "nodes that some tet uses");
    visit.field("inverted", s.inverted, "tets of no volume or turned inside out");
    visit.field("volume", s.volume, "sum over tets, cubic metres");
    visit.field("min_dihedral_deg", s.min_dihedral_deg, "smallest dihedral angle of the mesh");
    visit.field("p1_dihedral_deg", s.p1_dihedral_deg, "1st percentile over tets of the tet's smallest angle");
    visit.field("p5_dihedral_deg", s.p5_dihedral_deg, "5th percentile over tets of the tet's smallest angle");
    visit.field("median_dihedral_deg", s.median_dihedral_deg, "median over tets of the tet's smallest angle");
    visit.field("max_dihedral_deg", s.max_dihedral_deg, "largest dihedral angle of the mesh");
    visit.field("below_10_deg", s.below_10_deg, "tets with an angle below 10 degrees");
    visit.field("radius_ratio_min", s.radius_ratio_min,
                "least 3 inscribed / circumscribed radius, 1 for a regular tet");
    visit.field("radius_ratio_p5", s.radius_ratio_p5, "5th percentile of the radius ratio");
    visit.field("volume_lrms3_min", s.volume_lrms3_min, "least 6 sqrt(2) volume / lrms^3, 1 for a regular tet");
    visit.field("edge_ratio", s.edge_ratio, "longest over shortest edge of the mesh");
    visit.field("element_step_m", s.element_step_m,
                "least stable explicit step of an element times the speed of sound, metres");
    visit.field("element_step_ratio", s.element_step_ratio,
                "that step over a regular tet's of the mean volume, 1 is ideal");
    visit.field("stiffness_ratio", s.stiffness_ratio, "stiffest element over the median one");
}

[[nodiscard]] Summary summarize(std::span<const Vec3> positions, std::span<const Tet> tets,
                                const Context& context = {});
[[nodiscard]] Summary summarize(const TetMesh& mesh, const Context& context = {});

// What selects between meshes: fewer tets below 10 degrees, then the higher 1st percentile. Exact comparisons of angle
// keys.
struct Score {
    std::uint32_t below_10_deg = 0;
    AngleKey p1_dihedral = 0;
    AngleKey p5_dihedral = 0;  // told, not compared
    AngleKey median_dihedral = 0;
};
[[nodiscard]] Score score_of(std::span<const Vec3> positions, std::span<const Tet> tets, const Context& context = {});
[[nodiscard]] bool is_better(const Score& a, const Score& b);

// The `count` tets of smallest angle, flattest first, ties by place: index, centre, angle in the name.
[[nodiscard]] std::vector<Place> worst_tets(std::span<const Vec3> positions, std::span<const Tet> tets,
                                            std::size_t count = max_places);

// The same by element step, shortest first.
[[nodiscard]] std::vector<Place> stiffest_tets(std::span<const Vec3> positions, std::span<const Tet> tets,
                                               std::size_t count = max_places);

}
