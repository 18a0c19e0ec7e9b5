// SPDX-License-Identifier: GPL-3.0-or-later
// Puts random points inside the shell. Their number sets the size of the system a game has to solve.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/point_set.h"
#include "mesh/shell.h"
#include "sample/count.h"

namespace crumple::sample {

inline constexpr int version = 1;

enum class Method { poisson, uniform };
inline constexpr EnumName<Method> method_names[] = {{Method::poisson, "poisson"}, {Method::uniform, "uniform"}};
constexpr std::span<const EnumName<Method>> enum_names(Method) { return method_names; }

struct Params {
    std::string points = "auto";
    Method method = Method::poisson;
    double clearance = 0.4;
    bool painted_density = false;
    std::uint64_t seed = 1;
};

// h is the element size the shell suggests at a place: the mean edge of the nearest shell vertices, growing by 0.3
// inwards.
struct Report {
    std::uint64_t shell_vertices = 0;
    std::uint64_t points = 0;           // placed inside
    std::uint64_t given_points = 0;     // vertices of the shell within it that no triangle uses: they count as points
    std::uint64_t wanted = 0;           // by the recipe, or automatic_count
    std::uint64_t automatic_count = 0;  // integral of 1 / (0.7 h^3) over what is fillable and 0.35 h from the shell
    std::uint64_t expected_tets = 0;    // when all is finished, within 10 %
    std::uint64_t candidates = 0;
    std::uint64_t tries = 0;
    double free_volume = 0;  // cubic metres, fillable and 0.35 h from the shell
    double size_min = 0;     // least and largest h where points may lie, metres
    double size_max = 0;
    std::uint64_t thin_triangles = 0;  // where one layer of tets fits
    double thin_share = 0;             // of the surface
    double thinnest = 0;               // metres, there
    double spacing = 0;                // no two points are nearer than this times h; 0 when the method does not say
    std::vector<Finding> findings;  // SAMPLE_NO_INTERIOR, SAMPLE_FEWER_POINTS, SAMPLE_COUNT_LIMITED, SAMPLE_FEWER_TETS,
                                    // SAMPLE_NO_DENSITY, SAMPLE_OPEN_SHELL, SAMPLE_THIN
};

template <class Visitor, FieldsOf<Params> P>
void describe(Visitor& visit, P& p) {
    visit.field("points", p.points, count_pattern,
                "interior points: \"auto\" (as the shell's edges suggest), a number such as \"500\", or \"tets:5000\" "
                "for about "
                "that many tets in all");
    visit.field(
        "method", p.method,
        "poisson: evenly spread, finer where the shell is finer; uniform: independent, the same density everywhere");
    visit.field("clearance", p.clearance, Range{0, 10},
                "least distance of a point from the shell, in element sizes there");
    visit.field(
        "painted_density", p.painted_density,
        "the green channel scales the density near the shell: 0 an eighth, 0.5 as without paint, 1 eight times");
    visit.field("seed", p.seed, Range{0, 9007199254740991.0}, "another seed, other points");
}

template <class Visitor, FieldsOf<Report> R>
void describe(Visitor& visit, R& r) {
    visit.field("shell_vertices", r.shell_vertices, "vertices of the shell, which come first among the points");
    visit.field("points", r.points, "points placed inside");
    visit.field("given_points", r.given_points,
                "vertices of the shell within it that no triangle uses; they count as points");
    visit.field("wanted", r.wanted, "points asked for");
    visit.field("automatic_count", r.automatic_count, "points that the shell's edge lengths suggest");
    visit.field("expected_tets", r.expected_tets, "about how many tets there will be in the end");
    visit.field("candidates", r.candidates, "places the method chose from");
    visit.field("tries", r.tries, "random draws made to find them");
    visit.field("free_volume", r.free_volume, "space that takes points, cubic metres");
    visit.field("size_min", r.size_min, "smallest element size in that space, metres");
    visit.field("size_max", r.size_max, "largest element size in that space, metres");
    visit.field("thin_triangles", r.thin_triangles, "triangles of the shell where only one layer of tets fits");
    visit.field("thin_share", r.thin_share, "share of the surface they cover");
    visit.field("thinnest", r.thinnest, "least thickness there, metres");
    visit.field("spacing", r.spacing, "no two points are nearer than this times the element size; 0 for uniform");
    visit.field("findings", r.findings, "what a person should know");
}

// Throws Error(usage) for a count that cannot be read.
void check_params(const Params& params);

struct Result {
    PointSet points;  // shell vertices first, then interior points rounded to float
    Report report;
};

// No point lies outside, in a cavity, in a component that is rigid or locked as a whole, or on another point.
// Throws Error(usage) for a count that cannot be read.
[[nodiscard]] Result sample_interior(const Shell& shell, const Params& params = {}, const Context& context = {});

}
