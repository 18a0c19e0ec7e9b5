// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample/cells.h"

#include <algorithm>
#include <cmath>

#include "core/parallel_for.h"

namespace crumple::sample {

namespace {

// A cell is split until its edge is below this share of h where the shell is near, or its radius below half of h where
// not.
constexpr double near_edge = 0.5;
constexpr double far_radius = 0.5;
// A shell with far too small edges somewhere gets coarser cells instead of taking all memory.
constexpr std::size_t max_cells = 2'000'000;
constexpr int max_depth = 20;

enum class Fate { dropped, kept, split };

struct Trial {
    Cell cell;
    Fate fate = Fate::dropped;
};

class Refinement {
public:
    Refinement(const Space& space, const SizingField& field, double clearance)
        : space_(space), field_(field), clearance_(clearance) {}

    [[nodiscard]] Cell root() const {
        const Vec3 size = space_.box().high - space_.box().low;
        Cell cell;
        cell.centre = (space_.box().low + space_.box().high) * 0.5;
        cell.half = std::max({size.x, size.y, size.z}) * 0.5;
        measure(cell, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
        return cell;
    }

    [[nodiscard]] Fate judge(Cell& cell, bool may_split) const;
    [[nodiscard]] Cell child_of(const Cell& parent, int octant) const;

private:
    void measure(Cell& cell, double size_at_most, double distance_at_most) const {
        cell.size = field_.at(cell.centre, size_at_most);
        cell.distance = space_.distance_to_surface(cell.centre, distance_at_most);
    }
    void estimate_share(Cell& cell) const;

    const Space& space_;
    const SizingField& field_;
    double clearance_;
};

Cell Refinement::child_of(const Cell& parent, int octant) const {
    Cell cell;
    cell.half = parent.half / 2;
    const auto side = [&](int bit) { return octant & bit ? cell.half : -cell.half; };
    cell.centre = parent.centre + Vec3{side(1), side(2), side(4)};
    cell.is_one_material = parent.is_one_material;
    // What holds at the parent's centre bounds the child's from above; a little slack keeps rounding out of it.
    const double between = cell.radius() * 1.000001;
    measure(cell, (parent.size + size_growth * between) * 1.000001, (parent.distance + between) * 1.000001);
    return cell;
}

// Linear across the band in which the cell passes from too near to far enough.
void Refinement::estimate_share(Cell& cell) const {
    const double beyond = cell.distance - counted_clearance * cell.size;
    cell.share = cell.is_clear ? 1 : std::clamp(beyond / (2 * cell.half) + 0.5, 0.0, 1.0);
    if (!cell.is_one_material && cell.share > 0 && !space_.is_fillable(cell.centre)) cell.share = 0;
}

Fate Refinement::judge(Cell& cell, bool may_split) const {
    const double radius = cell.radius();
    if (cell.distance + radius < std::min(clearance_, counted_clearance) * cell.least_size()) return Fate::dropped;
    if (!cell.is_one_material && space_.is_watertight() && cell.distance > radius) {
        if (!space_.is_fillable(cell.centre)) return Fate::dropped;
        cell.is_one_material = true;
    }
    const double largest_size = cell.size + size_growth * radius;
    cell.is_clear =
        cell.is_one_material && cell.distance - radius > std::max(clearance_, counted_clearance) * largest_size;
    const bool is_fine = cell.is_clear ? radius <= far_radius * cell.size : 2 * cell.half <= near_edge * cell.size;
    if (!is_fine && may_split) return Fate::split;
    estimate_share(cell);
    return Fate::kept;
}

std::vector<Trial> children_of(const std::vector<Cell>& parents, const Refinement& refinement, bool may_split,
                               const Context& context) {
    std::vector<Trial> trials(parents.size() * 8);
    parallel_for(context, trials.size(), 256, [&](std::size_t begin, std::size_t end) {
        context.stop_if_cancelled();
        for (std::size_t i = begin; i < end; ++i) {
            trials[i].cell = refinement.child_of(parents[i / 8], static_cast<int>(i % 8));
            trials[i].fate = refinement.judge(trials[i].cell, may_split);
        }
    });
    return trials;
}

}

std::vector<Cell> find_cells(const Space& space, const SizingField& field, double clearance, const Context& context) {
    std::vector<Cell> kept;
    if (field.is_empty()) return kept;
    const Refinement refinement(space, field, clearance);
    std::vector<Cell> to_split{refinement.root()};
    for (int depth = 1; !to_split.empty(); ++depth) {
        const bool may_split = depth < max_depth && kept.size() + to_split.size() * 64 <= max_cells;
        std::vector<Cell> next;
        for (const Trial& trial : children_of(to_split, refinement, may_split, context)) {
            if (trial.fate == Fate::kept) kept.push_back(trial.cell);
            if (trial.fate == Fate::split) next.push_back(trial.cell);
        }
        to_split = std::move(next);
    }
    return kept;
}

}
