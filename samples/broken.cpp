// SPDX-License-Identifier: MIT
#include "samples/broken.h"

#include <algorithm>

#include "samples/solids.h"

namespace crumple::samples {
namespace {

// The sound shell that the faults are put into: a rounded box of half a metre, its lowest vertices locked.
Part sound(std::string_view name, Vec3 centre = {0, 0.5, 0}) {
    Part part{std::string(name), {}, {}, {}};
    add_box(part, {centre, {0.5, 0.4, 0.5}, {5, 4, 5}, 0.35}, unlocked);
    double lowest = part.positions.front().y;
    for (const auto& p : part.positions) lowest = std::min(lowest, p.y);
    for (std::size_t v = 0; v < part.positions.size(); ++v) {
        if (part.positions[v].y < lowest + 0.05) part.colors[v] = locked;
    }
    return part;
}

Model open() {  // a quad is missing
    Part part = sound("open");
    part.triangles.resize(part.triangles.size() - 2);
    return {part};
}

Model non_manifold() {  // two boxes share an edge: four triangles meet there
    Part part{"non_manifold", {}, {}, {}};
    add_box(part, {{-0.25, 0.5, 0}, {0.25, 0.25, 0.5}, {1, 1, 1}, 0}, unlocked);
    add_box(part, {{0.25, 1.0, 0}, {0.25, 0.25, 0.5}, {1, 1, 1}, 0}, unlocked);
    part.colors.front() = locked;
    // The corners of the shared edge, x 0, y 0.75, become the same vertices.
    for (auto& triangle : part.triangles) {
        for (auto& corner : triangle) {
            const auto first = std::find(part.positions.begin(), part.positions.end(), part.positions[corner]);
            corner = static_cast<Index>(first - part.positions.begin());
        }
    }
    return {part};
}

Model flipped() {  // one triangle faces the other way
    Part part = sound("flipped");
    std::swap(part.triangles[10][1], part.triangles[10][2]);
    return {part};
}

Model inside_out() {  // every triangle faces inwards
    Part part = sound("inside_out");
    for (auto& triangle : part.triangles) std::swap(triangle[1], triangle[2]);
    return {part};
}

Model self_intersecting() {  // the top is pushed out through the floor
    Part part = sound("self_intersecting");
    for (auto& p : part.positions) {
        const bool is_middle_of_top = p.y > 0.85 && std::abs(p.x) < 0.15 && std::abs(p.z) < 0.15;
        if (is_middle_of_top) p = round_to_float({p.x, p.y - 1.1, p.z});
    }
    return {part};
}

Model overlapping() {  // two solids take the same space
    return {sound("left"), sound("right", {0.45, 0.62, 0.1})};
}

Model duplicate() {  // some triangles are there twice
    Part part = sound("duplicate");
    for (std::size_t t = 0; t < 6; ++t) part.triangles.push_back(part.triangles[t * 7]);
    return {part};
}

Model degenerate() {  // triangles without area: corners in a line where a vertex sits on its neighbour's edge, a corner
                      // twice
    Part part{"degenerate", {}, {}, {}};
    add_box(part, {{0, 0.5, 0}, {0.5, 0.5, 0.5}, {2, 2, 2}, 0}, unlocked);
    part.colors.front() = locked;
    const auto [a, b, c] = part.triangles.front();
    const Index middle =
        add_vertex(part, (part.positions[a] + part.positions[b]) * 0.5, unlocked);  // exact: halves of halves
    part.triangles.front() = {a, middle, c};
    part.triangles.push_back({middle, b, c});
    part.triangles.push_back({a, b, middle});
    part.triangles.push_back({a, a, b});
    return {part};
}

Model thin_sheet() {  // closed and clean, a millimetre thick
    Part part{"thin_sheet", {}, {}, {}};
    add_box(part, {{0, 0.5, 0}, {0.5, 0.0005, 0.5}, {8, 1, 8}, 0}, unlocked);
    part.colors.front() = locked;
    return {part};
}

Model needle() {  // closed and clean, a thousand times as long as thick
    Part part{"needle", {}, {}, {}};
    add_box(part, {{0, 0.5, 0}, {1, 0.001, 0.001}, {8, 1, 1}, 0}, unlocked);
    part.colors.front() = locked;
    return {part};
}

Model nothing_painted() {  // no colours in the file at all
    Part part = sound("nothing_painted");
    part.colors.clear();
    return {part};
}

Model all_painted() {  // black everywhere, as some tools export unpainted meshes
    Part part = sound("all_painted");
    paint(part, {0, 0, 0, 255});
    return {part};
}

Model points_only() {  // no triangle at all
    Part part = sound("points_only");
    part.triangles.clear();
    return {part};
}

// Codes are those of the importer, see lib/importer.
constexpr BrokenShell table[] = {
    {"open", "SHELL_OPEN", open},
    {"non_manifold", "SHELL_NON_MANIFOLD", non_manifold},
    {"flipped", "SHELL_INCONSISTENT", flipped},
    {"inside_out", "SHELL_INVERTED", inside_out},
    {"self_intersecting", "SHELL_SELF_INTERSECTING", self_intersecting},
    {"overlapping", "SHELL_OVERLAPPING", overlapping},
    {"duplicate", "SHELL_DUPLICATE", duplicate},
    {"degenerate", "SHELL_DEGENERATE", degenerate},
    {"thin_sheet", "", thin_sheet},
    {"needle", "", needle},
    {"nothing_painted", "LOCK_NOTHING_PAINTED", nothing_painted},
    {"all_painted", "LOCK_NEARLY_ALL", all_painted},
    {"points_only", "", points_only},
};

}

std::span<const BrokenShell> broken_shells() { return table; }

}
