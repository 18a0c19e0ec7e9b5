// SPDX-License-Identifier: GPL-3.0-or-later
// What sampling asks of a place: how large elements should be there, how far the shell is, and whether a point put
// there would move. Sizes and distances are asked of the few vertices and triangles that matter near the place (see
// cells.h).
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/index.h"
#include "core/vec3.h"
#include "geometry/bvh.h"
#include "geometry/measures.h"
#include "mesh/shell.h"
#include "mesh/shell_interior.h"
#include "sample/face.h"

namespace crumple::sample {

// Element sizes grow this fast away from the shell: metres per metre.
inline constexpr double size_growth = 0.3;

class Space {
public:
    // factor: V or empty, what the size at each vertex is multiplied by. The shell must outlive this.
    Space(const Shell& shell, std::vector<double> factor);

    [[nodiscard]] const Box& box() const { return box_; }  // of the triangles
    // Metres by which rounding to float may move a place of the box.
    [[nodiscard]] double rounding() const { return rounding_; }
    // Closed everywhere and wound one way, so that material can only change across the shell.
    [[nodiscard]] bool is_watertight() const { return is_watertight_; }
    // Inside a solid component that is not locked as a whole.
    [[nodiscard]] bool is_fillable(Vec3 p) const;

    // Vertices that suggest a size, and triangles: all there are.
    [[nodiscard]] const std::vector<Index>& sized_vertices() const { return sized_vertices_; }
    [[nodiscard]] const std::vector<Index>& triangles() const { return triangles_; }

    // h(p) = min over vertices v of f_v L_v + 0.3 |p - v|, L_v the mean length of the shell's edges at v and f_v its
    // factor: as fine as the shell where it is near, coarser inside, and never changing faster than 0.3. Here the term
    // of one vertex.
    [[nodiscard]] double size_from(Index v, Vec3 p) const {
        return sizes_[v] + size_growth * length(p - shell_.positions[v]);
    }
    [[nodiscard]] double factor_of(Index v) const { return factors_.empty() ? 1 : factors_[v]; }
    [[nodiscard]] const Face& face(Index triangle) const { return faces_[triangle]; }
    [[nodiscard]] const FaceBall& ball(Index triangle) const { return balls_[triangle]; }
    // Metres, or `at_most` when no vertex is nearer.
    [[nodiscard]] double distance_to_vertex(Vec3 p, double at_most) const;

private:
    const Shell& shell_;
    ShellInterior interior_;
    Bvh vertex_tree_;
    Box box_;
    double rounding_ = 0;
    bool is_watertight_ = false;
    std::vector<std::uint8_t> fillable_;  // C
    std::vector<double> sizes_;           // V: f_v L_v, 0 where no edge of any length ends
    std::vector<double> factors_;         // V or empty
    std::vector<Index> sized_vertices_;
    std::vector<Index> triangles_;
    std::vector<Face> faces_;      // F
    std::vector<FaceBall> balls_;  // F
};

}
