// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/surface_guard.h"

#include <algorithm>

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

double squared_sine(double degrees) {
    const double sine = shape_of_angle(degrees);
    return sine * sine;
}

}

SurfaceGuard::SurfaceGuard(const Shell& shell, const SurfaceLimits& limits)
    : shell_(shell),
      limits_(limits),
      diagonal_(bounding_box(shell.positions).diagonal()),
      surface_(shell.positions, shell.triangles),
      triangles_(tree_of(shell.positions, shell.triangles)) {
    fold_sine_2_ = squared_sine(limits.fold_deg);
    crease_sine_2_ = squared_sine(std::max(crease_deg, limits.fold_deg));
    const double smooth_sine_2 = squared_sine(smooth_fold_deg);
    is_smooth_.assign(shell.positions.size(), 1);
    for (Index v = 0; v < is_smooth_.size(); ++v) is_smooth_[v] = !is_locked(shell, v);
    for (const Triangle& t : shell.triangles) faces_.push_back(turned(t));
    std::sort(faces_.begin(), faces_.end());
    const std::vector<Side> sides = sides_of(shell);
    for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
        while (next < sides.size() && sides[next].edge == sides[i].edge) ++next;
        const auto& [a, b] = sides[i].edge;
        const auto folds_within = [&](double sine_2) {
            return is_fold_within(normal_of(shell, sides[i].face), normal_of(shell, sides[i + 1].face), sine_2);
        };
        if (next - i != 2 || !folds_within(smooth_sine_2)) is_smooth_[a] = is_smooth_[b] = 0;
        if (next - i != 2 || (is_locked(shell, a) && is_locked(shell, b)) ||
            shell.component[sides[i].face] != shell.component[sides[i + 1].face]) {
            marked_.push_back(sides[i].edge);
            continue;
        }
        if (!folds_within(fold_sine_2_)) sharp_.push_back(sides[i].edge);
        if (!folds_within(crease_sine_2_)) creases_.push_back(sides[i].edge);
    }
}

bool SurfaceGuard::is_marked(Index a, Index b) const { return holds(marked_, sorted(a, b)); }

bool SurfaceGuard::is_shell_triangle(Index a, Index b, Index c) const { return holds(faces_, turned({a, b, c})); }

// By how much the surface may move; negative: not at all.
double SurfaceGuard::allowed_gap(const SurfacePatch& patch, bool is_sharp) const {
    if (!patch.is_flat(crease_sine_2_)) return -1;
    const bool is_folded = is_sharp || !patch.is_flat(fold_sine_2_);
    const double share =
        is_folded ? std::min(limits_.share_of_edge_folded, limits_.share_of_edge) : limits_.share_of_edge;
    return std::min(share * patch.mean_side(), limits_.share_of_diagonal * diagonal_);
}

// Where the new faces lie outside the old ones, nothing else of the shell may come near the space between.
bool SurfaceGuard::is_clear(const SurfacePatch& patch, const std::array<Index, 4>& nodes) const {
    if (orient3d(patch.a, patch.p, patch.b, patch.q) <= 0) return true;
    Box box;
    for (const Vec3 v : {patch.a, patch.p, patch.b, patch.q}) box.add(v);
    bool clear = true;
    triangles_.touching(box, [&](Index f) {
        const Triangle& t = shell_.triangles[f];
        const bool is_joined = std::find_first_of(t.begin(), t.end(), nodes.begin(), nodes.end()) != t.end();
        const auto& p = shell_.positions;
        clear = is_joined || patch.is_clear_of({p[t[0]], p[t[1]], p[t[2]]});
        return !clear;
    });
    return clear;
}

bool SurfaceGuard::may_flip(const WorkMesh& mesh, Index a, Index b, Index p, Index q) const {
    const std::array<Index, 4> nodes{a, p, b, q};
    if (std::any_of(nodes.begin(), nodes.end(), [&](Index v) { return mesh.is_pinched[v]; })) return false;
    const Edge edge = sorted(a, b);
    if (holds(marked_, edge) || holds(creases_, edge)) return false;
    const SurfacePatch patch{mesh.at(a), mesh.at(p), mesh.at(b), mesh.at(q)};
    const double limit = allowed_gap(patch, holds(sharp_, edge));
    if (patch.gap() > limit || mesh.complex.find_edge(p, q) != none) return false;
    const double before = distance_to_shell((patch.a + patch.b) * 0.5);
    return distance_to_shell((patch.p + patch.q) * 0.5) <= std::max(before, limit) && is_clear(patch, nodes);
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
    const double smooth_sine_2 = squared_sine(smooth_fold_deg);
    double nearest = 1e300;
    double edges = 0;
    for (const auto& [a, b] : link) {
        const Vec3 before = area_vector(at[node], at[a], at[b]);
        if (!is_fold_within(before, area_vector(to, at[a], at[b]), smooth_sine_2)) return false;
        nearest = std::min(nearest, length(closest_point_on_triangle(to, at[a], at[b], home) - home));
        edges += length(at[a] - at[node]);
    }
    if (link.empty()) return false;
    const double mean_edge = edges / static_cast<double>(link.size());
    const double limit = std::min(limits_.share_of_edge * mean_edge, limits_.share_of_diagonal * diagonal_);
    return nearest <= limit && distance_to_shell(to) <= limit;
}

}
