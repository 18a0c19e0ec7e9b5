// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/openness.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.h"
#include "core/parallel_for.h"
#include "core/short_text.h"
#include "geometry/boundary_loops.h"
#include "geometry/measures.h"
#include "mesh/shell_interior.h"

namespace crumple::importer {

namespace {

// A hole smaller than this, in diagonals, leaks only where it is.
constexpr double small_hole = 0.1;
// Leak shares up to which a large hole does no harm, and from which on nothing can be trusted.
constexpr double harmless_leak = 0.02;
constexpr double hopeless_leak = 0.1;

constexpr std::size_t place_count = 20'000;

void measure_holes(const Shell& shell, double diagonal, Openness& openness) {
    std::vector<std::vector<Triangle>> triangles(shell.components.size());
    for (std::size_t f = 0; f < shell.triangles.size(); ++f)
        triangles[shell.component[f]].push_back(shell.triangles[f]);
    for (std::size_t c = 0; c < triangles.size(); ++c) {
        if (shell.components[c].is_closed) continue;
        for (const std::vector<Index>& loop : boundary_loops(triangles[c])) {
            Box box;
            for (const Index v : loop) box.add(shell.positions[v]);
            ++openness.holes;
            if (box.diagonal() / diagonal <= openness.largest_hole) continue;
            openness.largest_hole = box.diagonal() / diagonal;
            openness.place = {(box.low + box.high) * 0.5, loop.front(), shell.components[c].name};
        }
    }
}

// Evenly spread places of the unit cube: multiples of powers of the root of x^4 = x + 1 [Roberts 2018].
Vec3 spread_place(std::size_t number) {
    constexpr double root = 1.2207440846057596;
    const auto part = [&](double step) {
        const double sum = 0.5 + static_cast<double>(number) * step;
        return sum - std::floor(sum);
    };
    return {part(1 / root), part(1 / (root * root)), part(1 / (root * root * root))};
}

// A single sheet leaks on both sides of itself: the box grows so that both are looked at.
double estimate_leak(const Shell& shell, const Context& context) {
    Box box = bounding_box(shell.positions);
    const double margin = 0.05 * box.diagonal();
    box.low = box.low - Vec3{margin, margin, margin};
    box.high = box.high + Vec3{margin, margin, margin};
    const Vec3 size = box.high - box.low;
    const ShellInterior interior(shell);
    std::vector<std::uint8_t> is_considered(place_count, 0);
    std::vector<std::uint8_t> is_undecided(place_count, 0);
    parallel_for(context, place_count, 500, [&](std::size_t begin, std::size_t end) {
        context.stop_if_cancelled();
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3 part = spread_place(i);
            const double winding =
                interior.material_winding(box.low + Vec3{part.x * size.x, part.y * size.y, part.z * size.z});
            is_considered[i] = winding >= 0.3;
            is_undecided[i] = winding >= 0.3 && winding <= 0.7;
        }
    });
    const auto considered = std::count(is_considered.begin(), is_considered.end(), 1);
    const auto undecided = std::count(is_undecided.begin(), is_undecided.end(), 1);
    return considered > 0 ? static_cast<double>(undecided) / static_cast<double>(considered) : 1;
}

}

Openness measure_openness(const Shell& shell, const Context& context) {
    Openness openness;
    const bool is_closed = std::all_of(shell.components.begin(), shell.components.end(),
                                       [](const Component& component) { return component.is_closed; });
    const double diagonal = bounding_box(shell.positions).diagonal();
    if (is_closed || !(diagonal > 0)) return openness;
    measure_holes(shell, diagonal, openness);
    openness.leak_share = estimate_leak(shell, context);
    return openness;
}

std::vector<Finding> judge_openness(const Openness& openness, double diagonal, bool is_caged) {
    if (openness.holes == 0) return {};
    const std::string what =
        std::to_string(openness.holes) + (openness.holes == 1 ? " hole, " : " holes, the largest ") +
        short_text(openness.largest_hole * diagonal) + " m across (" + percent_text(openness.largest_hole) +
        " of the diagonal) in '" + openness.place.name + "'; inside and outside are a guess in " +
        percent_text(openness.leak_share) + " of the volume";
    const bool is_small = openness.largest_hole < small_hole;
    if (openness.leak_share < harmless_leak || is_caged)
        return {{"SHELL_HOLES", Severity::warning, what, openness.holes, {openness.place}}};
    const std::string remedy =
        "close it, give single sheets a thickness (import.thicken, metres), or put a lattice around the shell "
        "(import.cage, say 16 cells)";
    if (is_small || openness.leak_share <= hopeless_leak) {
        return {{"SHELL_LEAKS", Severity::warning, what + "; better " + remedy, openness.holes, {openness.place}}};
    }
    throw Error(ErrorKind::bad_input, "SHELL_LEAKS: " + what + "; the largest is at " +
                                          position_text(openness.place.position) + ": " + remedy);
}

}
