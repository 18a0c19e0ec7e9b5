// SPDX-License-Identifier: GPL-3.0-or-later
// Says where the surface of the tets may change: an edge of it may give way to the other diagonal of the two faces
// beside it only where that is as good as flat or hardly moves the surface, keeps to the shell and crosses nothing that
// means something to the artist.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "finish/surface_patch.h"
#include "finish/work_mesh.h"
#include "geometry/bvh.h"
#include "geometry/surface_distance.h"
#include "mesh/shell.h"

namespace crumple::finish {

struct SurfaceLimits {
    double fold_deg = 0.5;        // between the two faces, before and after
    double share_of_edge = 0.01;  // distance between the diagonals over the mean side of the four-cornered patch
    double share_of_edge_folded = 0.003;  // the same at a larger fold that is no crease
    double share_of_diagonal = 1e-3;      // the same over the shell's box diagonal, flat or folded
};

// An edge that folds more is a crease and stays however near the other diagonal is.
inline constexpr double crease_deg = 30;

// A vertex whose edges fold less lies on a smooth part of the shell and not on one of its features.
inline constexpr double smooth_fold_deg = 15;

class SurfaceGuard {
public:
    // Keeps a reference to the shell.
    SurfaceGuard(const Shell& shell, const SurfaceLimits& limits);

    // Whether the faces (a, p, b) and (a, b, q), counter-clockwise from outside, may become (a, p, q) and (p, b, q).
    [[nodiscard]] bool may_flip(const WorkMesh& mesh, Index a, Index b, Index p, Index q) const;

    // Whether the faces (node, from, to) of the surface, one for each edge of `link`, may become (target, from, to);
    // those that have the target vanish.
    [[nodiscard]] bool may_contract(std::span<const Vec3> at, std::span<const Edge> link, Index node,
                                    Index target) const;

    // Whether a node of the surface may go from its place to `to`: the faces around it, as the edges opposite it, keep
    // their normals, the new place keeps to the shell and `home` to the new faces.
    [[nodiscard]] bool may_slide(std::span<const Vec3> at, std::span<const Edge> link, Index node, Vec3 home,
                                 Vec3 to) const;

    // Where the artist put a shell vertex.
    [[nodiscard]] Vec3 home(Index vertex) const { return shell_.positions[vertex]; }

    // By shell vertex: not painted, on no edge that is marked or folds by more than smooth_fold_deg.
    [[nodiscard]] const std::vector<std::uint8_t>& smooth_vertices() const { return is_smooth_; }

    // An edge of the shell that is painted (both ends locked) or has not just two triangles of one component.
    [[nodiscard]] bool is_marked(Index a, Index b) const;

    // Whether the shell has this triangle, wound the same way.
    [[nodiscard]] bool is_shell_triangle(Index a, Index b, Index c) const;

    // Box diagonal of the shell.
    [[nodiscard]] double diagonal() const { return diagonal_; }

    // How far the surface may move, flat, where edges are this long, metres.
    [[nodiscard]] double surface_reach(double edge) const {
        return std::min(limits_.share_of_edge * edge, limits_.share_of_diagonal * diagonal_);
    }

    [[nodiscard]] double distance_to_shell(Vec3 p) const { return surface_.closest(p).distance; }

private:
    [[nodiscard]] double allowed_gap(const SurfacePatch& patch, bool is_sharp) const;
    [[nodiscard]] bool is_clear(const SurfacePatch& patch, const std::array<Index, 4>& nodes) const;

    const Shell& shell_;
    SurfaceLimits limits_;
    double fold_sine_2_;
    double crease_sine_2_;
    double diagonal_;
    SurfaceDistance surface_;
    Bvh triangles_;
    std::vector<std::uint8_t> is_smooth_;
    std::vector<Edge> marked_;     // ascending
    std::vector<Edge> creases_;    // of the shell, ascending
    std::vector<Edge> sharp_;      // of the shell, not flat to the limit; ascending
    std::vector<Triangle> faces_;  // smallest corner first, ascending
};

}
