// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/parallel_for.h"

namespace crumple::sample {

namespace {

// A cell is split until its edge is below this share of h where the shell is near, or its reach below that where not.
constexpr double near_edge = 0.5;
constexpr double far_reach = 0.7;
// A shell with far too small edges somewhere gets coarser cells instead of taking all memory.
constexpr std::size_t max_cells = 1'500'000;
constexpr std::size_t max_listed = 60'000'000;  // vertices and triangles in the cells' lists together
constexpr int max_depth = 20;
// Bounds derived from other places get a little slack, to keep rounding out of them.
constexpr double slack = 1.000001;
constexpr double infinity = std::numeric_limits<double>::infinity();

enum class Fate { dropped, kept, split };

struct Family {
    std::array<Cell, 8> cells;
    std::array<Fate, 8> fates;
};

class Refinement {
public:
    Refinement(const Space& space, double clearance)
        : space_(space),
          least_clearance_(std::min(clearance, counted_clearance)),
          largest_clearance_(std::max(clearance, counted_clearance)) {}

    [[nodiscard]] Cell root() const;
    [[nodiscard]] Family children_of(const Cell& parent, bool may_split) const;

private:
    // Measured at a centre for each of the parent's vertices or triangles, in their order.
    using Values = std::vector<double>;

    void place(Cell& cell, Vec3 centre, double half) const;
    void measure(Cell& cell, const Cell& parent, Values& sizes, Values& centre_distances_2) const;
    void keep_lists(Cell& cell, const Cell& parent, const Values& sizes, const Values& centre_distances_2) const;
    [[nodiscard]] Fate judge(Cell& cell, bool may_split) const;
    [[nodiscard]] double estimate_share(const Cell& cell) const;

    const Space& space_;
    double least_clearance_;
    double largest_clearance_;
};

void Refinement::place(Cell& cell, Vec3 centre, double half) const {
    cell.centre = centre;
    cell.half = half;
    cell.reach = half * 1.7320508075688774 + space_.rounding();
}

Cell Refinement::root() const {
    const Vec3 size = space_.box().high - space_.box().low;
    Cell everything;
    everything.vertices = space_.sized_vertices();
    everything.triangles = space_.triangles();
    Cell cell;
    place(cell, (space_.box().low + space_.box().high) * 0.5, std::max({size.x, size.y, size.z}) * 0.5);
    Values sizes;
    Values centre_distances_2;
    measure(cell, everything, sizes, centre_distances_2);
    cell.vertices = everything.vertices;
    cell.triangles = everything.triangles;
    return cell;
}

void Refinement::measure(Cell& cell, const Cell& parent, Values& sizes, Values& centre_distances_2) const {
    sizes.clear();
    cell.size = infinity;
    for (const Index v : parent.vertices) {
        sizes.push_back(space_.size_from(v, cell.centre));
        if (sizes.back() < cell.size) {
            cell.size = sizes.back();
            cell.sized_by = v;
        }
    }
    centre_distances_2.clear();
    cell.nearest = parent.nearest;
    double nearest_2 = parent.nearest == none ? infinity : space_.face(parent.nearest).distance_2(cell.centre);
    double nearest = std::sqrt(nearest_2);
    for (const Index t : parent.triangles) {
        centre_distances_2.push_back(space_.ball(t).centre_distance_2(cell.centre));
        if (!space_.ball(t).may_reach(centre_distances_2.back(), nearest)) continue;
        const double distance_2 = space_.face(t).distance_2(cell.centre);
        if (distance_2 >= nearest_2) continue;
        nearest_2 = distance_2;
        nearest = std::sqrt(nearest_2);
        cell.nearest = t;
    }
    cell.distance = nearest;
}

// Going `reach` away lets one vertex's term shrink and another's grow by 0.3 reach each, and likewise the
// distances.
void Refinement::keep_lists(Cell& cell, const Cell& parent, const Values& sizes,
                            const Values& centre_distances_2) const {
    const double largest_size = (cell.size + 2 * size_growth * cell.reach) * slack;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (sizes[i] <= largest_size) cell.vertices.push_back(parent.vertices[i]);
    }
    if (cell.is_clear) return;
    const double farthest = (cell.distance + 2 * cell.reach) * slack;
    for (std::size_t i = 0; i < centre_distances_2.size(); ++i) {
        const Index t = parent.triangles[i];
        if (space_.ball(t).may_reach(centre_distances_2[i], farthest)) cell.triangles.push_back(t);
    }
}

// Linear across the band in which a cell passes from too near to far enough.
double Refinement::estimate_share(const Cell& cell) const {
    if (cell.is_clear) return 1;
    if (!cell.is_fillable) return 0;
    const double beyond = cell.distance - counted_clearance * cell.size;
    return std::clamp(beyond / (2 * cell.half) + 0.5, 0.0, 1.0);
}

Fate Refinement::judge(Cell& cell, bool may_split) const {
    const double least_gap = least_clearance_ * cell.least_size(cell.reach);
    if (cell.distance + cell.reach < least_gap) return Fate::dropped;
    cell.is_fillable = space_.is_fillable(cell.centre);
    // Seen from a centre that is not, fillable places lie behind the shell.
    if (space_.is_watertight() && !cell.is_fillable && cell.reach - cell.distance < least_gap) return Fate::dropped;
    const bool is_far = cell.distance - cell.reach > largest_clearance_ * cell.largest_size(cell.reach);
    const bool is_clear = is_far && cell.is_fillable && space_.is_watertight();
    const bool is_fine = is_clear ? cell.reach <= far_reach * cell.size : 2 * cell.half <= near_edge * cell.size;
    if (!is_fine && may_split) return Fate::split;
    cell.is_clear = is_clear;
    cell.share = estimate_share(cell);
    return Fate::kept;
}

Family Refinement::children_of(const Cell& parent, bool may_split) const {
    Family family;
    Values sizes;
    Values centre_distances_2;
    for (int octant = 0; octant < 8; ++octant) {
        Cell& cell = family.cells[octant];
        const double half = parent.half / 2;
        const auto side = [&](int bit) { return octant & bit ? half : -half; };
        place(cell, parent.centre + Vec3{side(1), side(2), side(4)}, half);
        measure(cell, parent, sizes, centre_distances_2);
        family.fates[octant] = judge(cell, may_split);
        if (family.fates[octant] != Fate::dropped) keep_lists(cell, parent, sizes, centre_distances_2);
    }
    return family;
}

}

std::vector<Cell> find_cells(const Space& space, double clearance, const Context& context) {
    std::vector<Cell> kept;
    if (space.sized_vertices().empty()) return kept;
    const Refinement refinement(space, clearance);
    std::vector<Cell> to_split{refinement.root()};
    std::size_t listed = 0;
    for (int depth = 1; !to_split.empty(); ++depth) {
        const bool may_split =
            depth < max_depth && kept.size() + to_split.size() * 32 <= max_cells && listed <= max_listed;
        std::vector<Family> families(to_split.size());
        parallel_for(context, to_split.size(), 32, [&](std::size_t begin, std::size_t end) {
            context.stop_if_cancelled();
            for (std::size_t i = begin; i < end; ++i) families[i] = refinement.children_of(to_split[i], may_split);
        });
        to_split.clear();
        for (Family& family : families) {
            for (std::size_t i = 0; i < 8; ++i) {
                if (family.fates[i] == Fate::dropped) continue;
                listed += family.cells[i].vertices.size() + family.cells[i].triangles.size();
                (family.fates[i] == Fate::kept ? kept : to_split).push_back(std::move(family.cells[i]));
            }
        }
    }
    return kept;
}

double size_at(const Space& space, const Cell& cell, Vec3 p) {
    double size = infinity;
    for (const Index v : cell.vertices) size = std::min(size, space.size_from(v, p));
    return size;
}

double distance_at(const Space& space, const Cell& cell, Vec3 p) {
    double nearest_2 = space.face(cell.nearest).distance_2(p);
    double nearest = std::sqrt(nearest_2);
    for (const Index t : cell.triangles) {
        if (!space.ball(t).may_reach(space.ball(t).centre_distance_2(p), nearest)) continue;
        const double distance_2 = space.face(t).distance_2(p);
        if (distance_2 >= nearest_2) continue;
        nearest_2 = distance_2;
        nearest = std::sqrt(nearest_2);
    }
    return nearest;
}

}
