// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/thicken.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "core/counted.h"
#include "core/disjoint_sets.h"
#include "core/error.h"
#include "core/short_text.h"
#include "geometry/measures.h"
#include "importer/edges.h"

namespace crumple::importer {

namespace {

// At a sharp fold the vertex moves farther, so that the faces keep their distance; but no farther than this times it.
constexpr double longest_mitre = 2;

std::size_t corner(Index triangle, std::size_t k) { return 3 * std::size_t{triangle} + k % 3; }

// Two sides of one component that run opposite ways: the sheet goes on across them. All others are rim.
class Sheets {
public:
    Sheets(const Components& components, const Welded& shell);

    [[nodiscard]] bool is_sheet(Index triangle) const {
        return !components_.facts[components_.of_triangle[triangle]].is_closed;
    }
    // Corners of one number belong to one vertex of the sheet.
    [[nodiscard]] Index vertex(std::size_t corner) { return corners_.find(static_cast<Index>(corner)); }
    [[nodiscard]] bool is_rim(Index triangle, std::size_t side) const { return is_rim_[corner(triangle, side)]; }

private:
    void join(const HalfEdge& a, const HalfEdge& b);

    const Components& components_;
    DisjointSets corners_;      // 3 F
    std::vector<bool> is_rim_;  // 3 F: the side from this corner to the next
};

Sheets::Sheets(const Components& components, const Welded& shell)
    : components_(components), corners_(3 * shell.triangles.size()), is_rim_(3 * shell.triangles.size(), true) {
    // So many triangles at one edge are no sheet going on, and comparing each with each would take for ever.
    constexpr std::size_t most_sides = 64;
    std::vector<HalfEdge> sides;
    const std::vector<HalfEdge> half_edges = sorted_half_edges(shell.triangles);
    for_each_edge(half_edges, [&](std::span<const HalfEdge> edge) {
        if (edge.size() > most_sides) return;
        for (const HalfEdge& side : edge) {
            sides.clear();
            std::copy_if(edge.begin(), edge.end(), std::back_inserter(sides), [&](const HalfEdge& other) {
                return components.of_triangle[other.triangle] == components.of_triangle[side.triangle];
            });
            if (sides.size() == 2 && sides[0].ascends != sides[1].ascends) join(sides[0], sides[1]);
        }
    });
}

void Sheets::join(const HalfEdge& a, const HalfEdge& b) {
    is_rim_[corner(a.triangle, a.side)] = false;
    is_rim_[corner(b.triangle, b.side)] = false;
    const auto unite = [&](std::size_t one, std::size_t other) {
        corners_.unite(static_cast<Index>(one), static_cast<Index>(other));
    };
    unite(corner(a.triangle, a.side), corner(b.triangle, b.side + 1u));
    unite(corner(a.triangle, a.side + 1u), corner(b.triangle, b.side));
}

// Weights that make the normal exact on a sphere, from + * / and sqrt alone [Max 1999].
Vec3 weighted_normal(const Welded& shell, const Triangle& t, std::size_t k) {
    const Vec3 at = shell.positions[t[k]];
    const Vec3 to_next = shell.positions[t[(k + 1) % 3]] - at;
    const Vec3 to_last = shell.positions[t[(k + 2) % 3]] - at;
    const double weight = dot(to_next, to_next) * dot(to_last, to_last);
    return weight > 0 ? cross(to_next, to_last) / weight : Vec3{};
}

Vec3 unit(Vec3 v) {
    const double size = length(v);
    return size > 0 ? v / size : Vec3{};
}

// By corner number of the vertex: which way, and how many half thicknesses, the vertex moves.
std::vector<Vec3> offsets(const Welded& shell, Sheets& sheets) {
    const std::size_t corner_count = 3 * shell.triangles.size();
    std::vector<Vec3> normals(corner_count);
    for (Index t = 0; t < shell.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k)
            normals[sheets.vertex(corner(t, k))] += weighted_normal(shell, shell.triangles[t], k);
    }
    for (Vec3& normal : normals) normal = unit(normal);
    std::vector<double> lean(corner_count, 1);  // least cosine between the vertex's normal and its faces'
    for (Index t = 0; t < shell.triangles.size(); ++t) {
        const auto& [a, b, c] = shell.triangles[t];
        const Vec3 face = unit(area_vector(shell.positions[a], shell.positions[b], shell.positions[c]));
        for (std::size_t k = 0; k < 3; ++k) {
            const Index v = sheets.vertex(corner(t, k));
            lean[v] = std::min(lean[v], dot(face, normals[v]));
        }
    }
    for (std::size_t v = 0; v < corner_count; ++v) normals[v] = normals[v] / std::max(lean[v], 1 / longest_mitre);
    return normals;
}

void check_thickness(const Welded& shell, double thickness) {
    double largest = 0;
    for (const Vec3& p : shell.positions) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    const double least = largest * 0x1p-20;
    if (thickness >= least) return;
    throw Error(ErrorKind::usage, "import.thicken: " + short_text(thickness) + " m is too thin for float positions " +
                                      short_text(largest) + " m from the origin; at least " + short_text(least) + " m");
}

// Takes vertices and triangles over from one shell into another.
class Builder {
public:
    Builder(const Welded& from, Welded& to) : from_(from), to_(to), kept_(from.positions.size(), none) {}

    // Vertices of one place stay one: sheets side by side move their common vertex alike.
    Index add(Index vertex, Vec3 place) {
        const auto [found, is_new] =
            at_.try_emplace({place.x, place.y, place.z}, static_cast<Index>(to_.positions.size()));
        if (!is_new) {
            to_.locked[found->second] |= from_.locked[vertex];
            return found->second;
        }
        to_.positions.push_back(place);
        to_.locked.push_back(from_.locked[vertex]);
        to_.source_vertex.push_back(from_.source_vertex[vertex]);
        if (!from_.colors.empty()) to_.colors.push_back(from_.colors[vertex]);
        return found->second;
    }
    void mark(Index vertex) { kept_[vertex] = 0; }
    void keep_marked() {
        for (Index v = 0; v < kept_.size(); ++v) {
            if (kept_[v] != none) kept_[v] = add(v, from_.positions[v]);
        }
    }
    [[nodiscard]] Index kept(Index vertex) const { return kept_[vertex]; }
    void add_triangle(Triangle corners, Index part) {
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return;
        to_.triangles.push_back(corners);
        to_.part.push_back(part);
    }

private:
    const Welded& from_;
    Welded& to_;
    std::vector<Index> kept_;
    std::map<std::array<double, 3>, Index> at_;
};

Welded emptied(const Welded& shell) {
    Welded result = shell;
    result.positions.clear();
    result.colors.clear();
    result.locked.clear();
    result.source_vertex.clear();
    result.triangles.clear();
    result.part.clear();
    return result;
}

struct Pair {
    Index front = none;
    Index back = none;
};

void add_sheet_triangle(Builder& builder, const Sheets& sheets, Index t, const std::array<Pair, 3>& v, Index part) {
    builder.add_triangle({v[0].front, v[1].front, v[2].front}, part);
    builder.add_triangle({v[0].back, v[2].back, v[1].back}, part);
    for (std::size_t k = 0; k < 3; ++k) {
        if (!sheets.is_rim(t, k)) continue;
        const Pair& from = v[k];
        const Pair& to = v[(k + 1) % 3];
        builder.add_triangle({to.front, from.front, from.back}, part);
        builder.add_triangle({to.front, from.back, to.back}, part);
    }
}

}

Finding thicken_sheets(const Surface& surface, const Components& components, double thickness, Welded& shell) {
    Finding finding{"SHELL_THICKENED", Severity::warning, "", 0, {}};
    Sheets sheets(components, shell);
    Welded result = emptied(shell);
    Builder builder(shell, result);
    for (Index t = 0; t < shell.triangles.size(); ++t) {
        if (sheets.is_sheet(t)) {
            const Place place{shell.positions[shell.triangles[t][0]], t,
                              surface.objects[surface.parts[shell.part[t]].object].name};
            count_one(finding, place);
        } else {
            for (const Index v : shell.triangles[t]) builder.mark(v);
        }
    }
    if (finding.count == 0) return finding;
    check_thickness(shell, thickness);
    builder.keep_marked();
    const std::vector<Vec3> offset = offsets(shell, sheets);
    std::vector<Pair> pairs(offset.size());
    for (Index t = 0; t < shell.triangles.size(); ++t) {
        const Triangle& corners = shell.triangles[t];
        if (!sheets.is_sheet(t)) {
            builder.add_triangle({builder.kept(corners[0]), builder.kept(corners[1]), builder.kept(corners[2])},
                                 shell.part[t]);
            continue;
        }
        std::array<Pair, 3> v;
        for (std::size_t k = 0; k < 3; ++k) {
            const Index number = sheets.vertex(corner(t, k));
            if (pairs[number].front == none) {
                const Vec3 place = shell.positions[corners[k]];
                const Vec3 step = offset[number] * (thickness / 2);
                pairs[number] = {builder.add(corners[k], round_to_float(place + step)),
                                 builder.add(corners[k], round_to_float(place - step))};
            }
            v[k] = pairs[number];
        }
        add_sheet_triangle(builder, sheets, t, v, shell.part[t]);
    }
    finding.message = counted(finding.count, "triangle of open parts was", "triangles of open parts were") +
                      " given a thickness of " + short_text(thickness) +
                      " m: vertices lie half of that to either side of where the file has them";
    shell = std::move(result);
    return finding;
}

}
