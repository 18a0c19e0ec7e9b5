// SPDX-License-Identifier: GPL-3.0-or-later
// What sampling asks of a place: how large elements should be there, how far the shell is, and whether a deformable
// material fills it.
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "core/vec3.h"
#include "geometry/measures.h"
#include "mesh/shell.h"
#include "mesh/shell_interior.h"
#include "sample/box_tree.h"

namespace crumple::sample {

// Element sizes may grow this fast away from the shell: metres per metre.
inline constexpr double size_growth = 0.3;

// h(x) = min over vertices v of L_v + 0.3 |x - v|, L_v the mean length of the shell's edges at v: as fine as the shell
// where it is near, coarser inside, and never changing faster than 0.3.
class SizingField {
public:
    // factor: V or empty, what each L_v is multiplied by.
    SizingField(const Shell& shell, const std::vector<double>& factor);

    [[nodiscard]] bool is_empty() const { return tree_.items.empty(); }  // no triangle has an edge of any length
    // `at_most` may be any value known not to be below h(p): it saves time.
    [[nodiscard]] double at(Vec3 p, double at_most = std::numeric_limits<double>::infinity()) const;
    [[nodiscard]] double least() const { return is_empty() ? 0 : least_[0]; }

private:
    void build(std::vector<Vec3> positions, std::vector<double> sizes);
    void drop_vertices_that_never_win();

    std::vector<Vec3> positions_;  // of the vertices that matter
    std::vector<double> sizes_;    // their L
    BoxTree tree_;
    std::vector<double> least_;  // least L in each node of the tree
};

class Space {
public:
    explicit Space(const Shell& shell);

    [[nodiscard]] const Box& box() const { return box_; }
    // Closed everywhere and wound one way, so that material can only change across the shell.
    [[nodiscard]] bool is_watertight() const { return is_watertight_; }
    // Metres to the nearest triangle, or `at_most` when none is nearer.
    [[nodiscard]] double distance_to_surface(Vec3 p, double at_most = std::numeric_limits<double>::infinity()) const;
    [[nodiscard]] double distance_to_vertex(Vec3 p, double at_most) const;
    // Whether a point put here would move: inside a solid component that is not locked as a whole.
    [[nodiscard]] bool is_fillable(Vec3 p) const;

private:
    const Shell& shell_;
    ShellInterior interior_;
    std::vector<std::uint8_t> fillable_;  // C
    Box box_;                             // of the triangles
    BoxTree triangles_;
    BoxTree vertices_;
    bool is_watertight_ = false;
};

}
