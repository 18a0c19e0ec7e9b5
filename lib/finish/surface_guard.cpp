// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/surface_guard.h"

#include <algorithm>
#include <cmath>

#include "geometry/measures.h"
#include "geometry/predicates.h"

namespace crumple::finish {

namespace {

Edge sorted(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

Triangle turned(Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

template <class T>
bool holds(const std::vector<T>& ascending, const T& value) {
    return std::binary_search(ascending.begin(), ascending.end(), value);
}

struct Side {
    Edge edge;
    Index face;
};

std::vector<Side> sides_of(const Shell& shell) {
    std::vector<Side> sides;
    sides.reserve(shell.triangles.size() * 3);
    for (Index f = 0; f < shell.triangles.size(); ++f) {
        const auto& [a, b, c] = shell.triangles[f];
        sides.insert(sides.end(), {{sorted(a, b), f}, {sorted(b, c), f}, {sorted(c, a), f}});
    }
    std::sort(sides.begin(), sides.end(),
              [](const Side& x, const Side& y) { return x.edge != y.edge ? x.edge < y.edge : x.face < y.face; });
    return sides;
}

bool is_locked(const Shell& shell, Index v) { return v < shell.locked.size() && shell.locked[v]; }

Vec3 normal_of(const Shell& shell, Index face) {
    const auto& [a, b, c] = shell.triangles[face];
    return area_vector(shell.positions[a], shell.positions[b], shell.positions[c]);
}

// Both normals point to the same side and enclose an angle of at most this sine.
bool is_fold_within(Vec3 n, Vec3 m, double sine_2) {
    const Vec3 turn = cross(n, m);
    return dot(n, m) > 0 && dot(turn, turn) <= sine_2 * dot(n, n) * dot(m, m);
}

std::vector<Box> boxes_of(const Shell& shell) {
    std::vector<Box> boxes(shell.triangles.size());
    for (std::size_t f = 0; f < boxes.size(); ++f) {
        for (const Index v : shell.triangles[f]) boxes[f].add(shell.positions[v]);
    }
    return boxes;
}

}

double gap_between(Vec3 a, Vec3 b, Vec3 p, Vec3 q) {
    const Vec3 across = cross(b - a, q - p);
    const double size = length(across);
    return size > 0 ? std::fabs(dot(p - a, across)) / size : 0;
}

SurfaceGuard::SurfaceGuard(const Shell& shell, const SurfaceLimits& limits)
    : shell_(shell),
      limits_(limits),
      diagonal_(bounding_box(shell.positions).diagonal()),
      surface_(shell.positions, shell.triangles),
      triangles_(boxes_of(shell)) {
    const double sine = shape_of_angle(limits.fold_deg);
    fold_sine_2_ = sine * sine;
    const double smooth_sine = shape_of_angle(smooth_fold_deg);
    is_smooth_.assign(shell.positions.size(), 1);
    for (Index v = 0; v < is_smooth_.size(); ++v) is_smooth_[v] = !is_locked(shell, v);
    for (const Triangle& t : shell.triangles) faces_.push_back(turned(t));
    std::sort(faces_.begin(), faces_.end());
    const std::vector<Side> sides = sides_of(shell);
    for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
        while (next < sides.size() && sides[next].edge == sides[i].edge) ++next;
        const auto& [a, b] = sides[i].edge;
        if (next - i != 2 || !is_fold_within(normal_of(shell, sides[i].face), normal_of(shell, sides[i + 1].face),
                                             smooth_sine * smooth_sine)) {
            is_smooth_[a] = is_smooth_[b] = 0;
        }
        if (next - i != 2 || (is_locked(shell, a) && is_locked(shell, b)) ||
            shell.component[sides[i].face] != shell.component[sides[i + 1].face]) {
            marked_.push_back(sides[i].edge);
        } else if (!is_fold_within(normal_of(shell, sides[i].face), normal_of(shell, sides[i + 1].face),
                                   fold_sine_2_)) {
            sharp_.push_back(sides[i].edge);
        }
    }
}

bool SurfaceGuard::is_marked(Index a, Index b) const { return holds(marked_, sorted(a, b)); }

bool SurfaceGuard::is_shell_triangle(Index a, Index b, Index c) const { return holds(faces_, turned({a, b, c})); }

// The triangles (a, b, c) and (c, b, d).
bool SurfaceGuard::is_flat(Vec3 a, Vec3 b, Vec3 c, Vec3 d) const {
    return is_fold_within(area_vector(a, b, c), area_vector(c, b, d), fold_sine_2_);
}

// Where the new faces lie outside the old ones, nothing else of the shell may come near the space between.
bool SurfaceGuard::is_clear(const WorkMesh& mesh, Index a, Index b, Index p, Index q) const {
    if (orient3d(mesh.at(a), mesh.at(p), mesh.at(b), mesh.at(q)) <= 0) return true;
    Box box;
    for (const Index v : {a, b, p, q}) box.add(mesh.at(v));
    bool clear = true;
    triangles_.touching(box, [&](Index f) {
        const Triangle& t = shell_.triangles[f];
        clear = std::any_of(t.begin(), t.end(), [&](Index v) { return v == a || v == b || v == p || v == q; });
        return !clear;
    });
    return clear;
}

bool SurfaceGuard::may_flip(const WorkMesh& mesh, Index a, Index b, Index p, Index q) const {
    for (const Index v : {a, b, p, q}) {
        if (mesh.is_pinched[v]) return false;
    }
    if (is_marked(a, b) || holds(sharp_, sorted(a, b))) return false;
    const Vec3 at_a = mesh.at(a);
    const Vec3 at_b = mesh.at(b);
    const Vec3 at_p = mesh.at(p);
    const Vec3 at_q = mesh.at(q);
    if (!is_flat(at_p, at_b, at_a, at_q) || !is_flat(at_a, at_p, at_q, at_b)) return false;
    const double gap = gap_between(at_a, at_b, at_p, at_q);
    const double sides = length(at_p - at_a) + length(at_b - at_p) + length(at_q - at_b) + length(at_a - at_q);
    const double limit = std::min(limits_.share_of_edge * sides / 4, limits_.share_of_diagonal * diagonal_);
    if (gap > limit || mesh.complex.find_edge(p, q) != none) return false;
    const double before = distance_to_shell((at_a + at_b) * 0.5);
    return distance_to_shell((at_p + at_q) * 0.5) <= std::max(before, limit) && is_clear(mesh, a, b, p, q);
}

// The node must lie next to the new faces, on their outer side by no more than rounding: then only what was filled
// before is filled after, up to what a game could not tell.
bool SurfaceGuard::may_contract(std::span<const Vec3> at, std::span<const Edge> link, Index node, Index target) const {
    const double edge = length(at[target] - at[node]);
    const double limit = std::min(limits_.share_of_edge * edge, limits_.share_of_diagonal * diagonal_);
    const double rounding = 1e-6 * diagonal_;
    const auto locked_ends =
        std::count_if(link.begin(), link.end(), [&](const Edge& e) { return is_locked(shell_, e[0]); });
    if (locked_ends > 1 && !is_locked(shell_, target)) return false;  // a painted edge may run through the node
    double nearest = edge;
    for (const auto& [from, to] : link) {
        if (from == target || to == target) continue;
        const Vec3 before = area_vector(at[node], at[from], at[to]);
        const Vec3 after = area_vector(at[target], at[from], at[to]);
        if (!(dot(before, after) > 0)) return false;
        const double height = dot(at[node] - at[target], after) / length(after);
        if (height < -rounding) return false;
        nearest =
            std::min(nearest, length(closest_point_on_triangle(at[target], at[from], at[to], at[node]) - at[node]));
    }
    return nearest <= std::max(limit, rounding);
}

bool SurfaceGuard::may_slide(std::span<const Vec3> at, std::span<const Edge> link, Index node, Vec3 home,
                             Vec3 to) const {
    const double smooth_sine = shape_of_angle(smooth_fold_deg);
    double nearest = 1e300;
    double edges = 0;
    for (const auto& [a, b] : link) {
        const Vec3 before = area_vector(at[node], at[a], at[b]);
        if (!is_fold_within(before, area_vector(to, at[a], at[b]), smooth_sine * smooth_sine)) return false;
        nearest = std::min(nearest, length(closest_point_on_triangle(to, at[a], at[b], home) - home));
        edges += length(at[a] - at[node]);
    }
    if (link.empty()) return false;
    const double mean_edge = edges / static_cast<double>(link.size());
    const double limit = std::min(limits_.share_of_edge * mean_edge, limits_.share_of_diagonal * diagonal_);
    return nearest <= limit && distance_to_shell(to) <= limit;
}

}
