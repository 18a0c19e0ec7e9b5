// SPDX-License-Identifier: GPL-3.0-or-later
#include "gates/judge.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "gates/judgement.h"
#include "mesh/boundary.h"

namespace crumple::gates {

namespace {

using quality::Badness;
using quality::PlaceTeller;
using quality::ShellLimit;

constexpr const char* thicken =
    "thicken it there, or cut its triangles finer until an edge is no longer than five times the thickness";
constexpr const char* mend_needle = "collapse the short edge of the shell's needle there, or turn its long one";
constexpr const char* part_surfaces =
    "one may be a copy of the other (then import names both, SHELL_NEARLY_DOUBLE): delete it, or move them apart by a "
    "fifth of their edges";
constexpr const char* mesh_better =
    "try more interior points (sample.points) or another seed (sample.seed), with finish.mode full";

std::string remedy_for(ShellLimit limit) {
    switch (limit) {
        case ShellLimit::none:
            return std::string("the shell does not force it: ") + mesh_better;
        case ShellLimit::thin:
            return std::string("the shell is too thin for its edges: ") + thicken;
        case ShellLimit::needle:
            return std::string("a triangle of the shell has such a corner: ") + mend_needle;
        case ShellLimit::gap:
            return std::string("two surfaces of the shell lie too close together for their edges: ") + part_surfaces;
    }
    return mesh_better;
}

struct Case {
    const quality::Figures& figures;
    const TetMesh& mesh;
    const Limits& limits;
    const PlaceTeller& teller;
    const quality::EmbeddingResult* embedding;
};

Judgement::Told worst_shapes(const Case& of, Badness badness) {
    PlaceTeller::Worst worst = of.teller.worst(badness);
    return {remedy_for(worst.limit), std::move(worst.places)};
}

void judge_inverted(Judgement& judgement, const Case& of) {
    if (of.figures.shape.inverted == 0) return;
    judgement.findings.push_back(
        {"GATE_INVERTED", Severity::error,
         "tets without volume or turned inside out: no solver can use this mesh; cook it again "
         "with finish.mode none and report it",
         of.figures.shape.inverted, of.teller.worst(Badness::flattest).places});
}

void judge_share_below_10(Judgement& judgement, const Case& of) {
    const quality::Figures& f = of.figures;
    const double counted = static_cast<double>(f.shape.below_10_deg) - static_cast<double>(f.below_10_thin);
    const auto tell = [&]() -> Judgement::Told {
        const std::uint64_t needles = f.below_10_needle;
        const std::uint64_t unforced = f.shape.below_10_deg - f.below_10_thin - needles;
        const std::uint64_t gaps = std::min(of.teller.count(ShellLimit::gap), unforced);
        const std::uint64_t free = unforced - gaps;
        const char* remedy = gaps > std::max(needles, free) ? part_surfaces
                             : needles > free               ? mend_needle
                                                            : mesh_better;
        std::string split = std::to_string(needles) + " lie on needles of the shell, ";
        if (gaps > 0) split += std::to_string(gaps) + " where its surfaces nearly meet, ";
        split += std::to_string(free) + " are not its fault (" + std::to_string(f.below_10_thin) +
                 " where it is thin do not count): ";
        return {split + remedy, of.teller.worst(Badness::flattest, ShellLimit::thin).places,
                static_cast<std::uint64_t>(counted)};
    };
    judgement.ask("GATE_BELOW_10_DEG", "the share of tets with an angle below 10 degrees", counted / f.shape.tets,
                  of.limits.below_10_share, Wanted::low, tell);
}

void judge_shapes(Judgement& judgement, const Case& of) {
    const quality::Summary& s = of.figures.shape;
    const auto shape = [&](const char* code, const char* what, double value, const Gate& gate, Wanted wanted,
                           Badness badness) {
        judgement.ask(code, what, value, gate, wanted, [&] { return worst_shapes(of, badness); });
    };
    shape("GATE_MIN_DIHEDRAL", "the smallest dihedral angle (degrees)", s.min_dihedral_deg, of.limits.min_dihedral_deg,
          Wanted::high, Badness::flattest);
    shape("GATE_MAX_DIHEDRAL", "the largest dihedral angle (degrees)", s.max_dihedral_deg, of.limits.max_dihedral_deg,
          Wanted::low, Badness::widest);
    judge_share_below_10(judgement, of);
    shape("GATE_P5_DIHEDRAL", "the 5th percentile of the tets' smallest angles (degrees)", s.p5_dihedral_deg,
          of.limits.p5_dihedral_deg, Wanted::high, Badness::flattest);
    shape("GATE_FLAT_TET", "the least volume / (mean edge)^3, 1 for a regular tet,", s.volume_lrms3_min,
          of.limits.volume_lrms3, Wanted::high, Badness::least_volume);
    shape("GATE_RADIUS_RATIO", "the least radius ratio, 1 for a regular tet,", s.radius_ratio_min,
          of.limits.radius_ratio, Wanted::high, Badness::least_radius);
}

void judge_cost(Judgement& judgement, const Case& of) {
    const auto stiff = [&](Badness badness) {
        return [&of, badness]() -> Judgement::Told {
            PlaceTeller::Worst worst = of.teller.worst(badness);
            if (worst.is_flat) return {"a flat tet sets it; " + remedy_for(worst.limit), std::move(worst.places)};
            return {"the shortest edges set it: merge the shell's vertices that lie close together there",
                    std::move(worst.places)};
        };
    };
    if (of.figures.shape.inverted == 0) {
        judgement.ask("GATE_DT_RATIO", "the largest stable step over that of regular tets", of.figures.cost.dt_ratio,
                      of.limits.dt_ratio, Wanted::high, stiff(Badness::least_step));
    }
    judgement.ask("GATE_STIFFNESS_RATIO", "the stiffest element over the median one", of.figures.shape.stiffness_ratio,
                  of.limits.stiffness_ratio, Wanted::low, stiff(Badness::stiffest));
}

void judge_fidelity(Judgement& judgement, const Case& of) {
    const quality::Fidelity& f = of.figures.fidelity;
    if (!f.is_known) return;
    const auto out = [&] { return of.teller.at(f.farthest_out, "the tets' surface is farthest from the shell"); };
    const auto in = [&] { return of.teller.at(f.farthest_in, "the shell is farthest from the tets"); };
    judgement.ask("GATE_VOLUME",
                  f.volume_error < 0 ? "the share of the shell's volume that is lost"
                                     : "the share of the shell's volume that is gained",
                  std::fabs(f.volume_error), of.limits.volume_error, Wanted::low, [&]() -> Judgement::Told {
                      return {
                          "faces of the shell are not faces of the tets: cut it finer where it is thin, and keep "
                          "recover and finish on",
                          {f.hausdorff_in > f.hausdorff_out ? in() : out()}};
                  });
    judgement.ask("GATE_LEAK", "the volume share where an open shell leaves open what is inside", f.leak_share,
                  of.limits.leak_share, Wanted::low, [&]() -> Judgement::Told {
                      return {"close its holes, or give a sheet a thickness", of.teller.holes()};
                  });
    if (!f.is_closed) return;
    judgement.ask("GATE_HAUSDORFF_OUT", "how far the tets' surface strays from the shell, in box diagonals,",
                  f.hausdorff_out, of.limits.hausdorff, Wanted::low, [&]() -> Judgement::Told {
                      return {"the tets bridge a hollow of the shell there: cut its triangles finer", {out()}};
                  });
    judgement.ask("GATE_HAUSDORFF_IN", "how far the shell strays from the tets, in box diagonals,", f.hausdorff_in,
                  of.limits.hausdorff, Wanted::low, [&]() -> Judgement::Told {
                      return {"the tets miss a part of the shell there: it is thin or its triangles are long", {in()}};
                  });
}

std::vector<Place> non_manifold_places(const Case& of) {
    const NonManifold found = non_manifold(boundary_of(of.mesh).faces);
    std::vector<Place> places;
    for (const Index v : found.vertices) {
        if (places.size() < max_places) places.push_back(of.teller.at_node(v));
    }
    return places;
}

// Every piece but the largest, smallest first.
std::vector<Place> piece_places(const Case& of) {
    const std::vector<Index> piece = pieces_of(of.mesh);
    struct Piece {
        Index tets = 0;
        Index first = none;
    };
    std::vector<Piece> pieces(of.figures.topology.pieces);
    for (Index t = 0; t < piece.size(); ++t) {
        Piece& p = pieces[piece[t]];
        if (p.tets++ == 0) p.first = t;
    }
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.tets < b.tets; });
    std::vector<Place> places;
    for (std::size_t i = 0; i + 1 < pieces.size() && i < max_places; ++i) {
        places.push_back(of.teller.at_tet(pieces[i].first, format("a piece of %u tets", pieces[i].tets)));
    }
    return places;
}

void judge_topology(Judgement& judgement, const Case& of) {
    const quality::Topology& t = of.figures.topology;
    const auto count = std::max(t.non_manifold_edges, t.non_manifold_vertices);
    judgement.ask("GATE_NON_MANIFOLD", "the number of places where the surface touches itself",
                  static_cast<double>(count), of.limits.non_manifold, Wanted::low, [&]() -> Judgement::Told {
                      return {
                          "forces pass there through an edge or a point alone: move the shell's sheets apart, or "
                          "join them over a whole face",
                          non_manifold_places(of), count};
                  });
    if (t.shell_pieces == 0 || t.pieces <= t.shell_pieces) return;
    const auto extra = t.pieces - t.shell_pieces;
    judgement.ask(
        "GATE_PIECES", "the number of pieces of tets more than the shell has", static_cast<double>(extra),
        of.limits.extra_pieces, Wanted::low, [&]() -> Judgement::Told {
            return {"they would fall apart: the shell is too thin or too coarse between them", piece_places(of), extra};
        });
}

void judge_embedding(Judgement& judgement, const Case& of) {
    const quality::Embedding& e = of.figures.embedding;
    if (e.vertices == 0) return;
    const auto places_of = [&](const std::vector<quality::HungVertex>& vertices) {
        std::vector<Place> places;
        for (const quality::HungVertex& vertex : vertices) places.push_back(of.teller.at_vertex(vertex));
        return places;
    };
    const auto weights = [&] { return of.embedding ? places_of(of.embedding->heaviest) : std::vector<Place>{}; };
    const auto wrong = [&] { return of.embedding ? places_of(of.embedding->wrong) : std::vector<Place>{}; };
    judgement.ask("GATE_OUTSIDE", "the share of visual vertices outside the tets",
                  static_cast<double>(e.outside) / static_cast<double>(e.vertices), of.limits.outside_share,
                  Wanted::low, [&]() -> Judgement::Told {
                      return {"let the shell enclose the visual meshes there", weights(), e.outside};
                  });
    judgement.ask(
        "GATE_MAX_WEIGHT", "the largest weight of a visual vertex", e.max_weight, of.limits.max_weight, Wanted::low,
        [&]() -> Judgement::Told {
            return {"it exaggerates what its tet does: let the shell enclose it, or use coarser tets there", weights()};
        });
    judgement.ask(
        "GATE_BOUND_WRONGLY", "the number of visual vertices on a tet of another shell",
        static_cast<double>(e.bound_wrongly), of.limits.bound_wrongly, Wanted::low, [&]() -> Judgement::Told {
            return {"name the shell component that a visual mesh hangs on (import.owners)", wrong(), e.bound_wrongly};
        });
}

}

std::vector<Finding> judge(const quality::Figures& figures, const TetMesh& mesh, const Shell* shell,
                           const Limits& limits, const quality::PlaceNames& names,
                           const quality::EmbeddingResult* embedding) {
    Judgement judgement;
    if (figures.shape.tets == 0) return {};
    const std::vector<Triangle> faces = shell ? std::vector<Triangle>{} : boundary_of(mesh).faces;
    const quality::Surface surface =
        shell ? quality::Surface{shell->positions, shell->triangles} : quality::Surface{mesh.positions, faces};
    const PlaceTeller teller(mesh, surface, names);
    const Case of{figures, mesh, limits, teller, embedding};
    judge_inverted(judgement, of);
    judge_shapes(judgement, of);
    judge_cost(judgement, of);
    judge_fidelity(judgement, of);
    judge_topology(judgement, of);
    judge_embedding(judgement, of);
    return std::move(judgement.findings);
}

}
