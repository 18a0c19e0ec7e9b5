// SPDX-License-Identifier: GPL-3.0-or-later
#include "cull/shell_solid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/disjoint_sets.h"
#include "geometry/measures.h"
#include "geometry/self_intersection.h"
#include "mesh/boundary.h"

namespace crumple::cull {

namespace {

struct DirectedEdge {
    Index component;
    Index low;
    Index high;
    int direction;
};

std::vector<std::uint8_t> closed_components(const Shell& shell) {
    std::vector<DirectedEdge> edges;
    edges.reserve(shell.triangles.size() * 3);
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        const auto& [a, b, c] = shell.triangles[f];
        for (const auto& [from, to] : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) {
            edges.push_back({shell.component[f], std::min(from, to), std::max(from, to), from < to ? 1 : -1});
        }
    }
    const auto key = [](const DirectedEdge& e) { return std::array<Index, 3>{e.component, e.low, e.high}; };
    std::sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
    std::vector<std::uint8_t> closed(shell.components.size(), 1);
    for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
        int balance = 0;
        for (; next < edges.size() && key(edges[next]) == key(edges[i]); ++next) balance += edges[next].direction;
        if (balance != 0) closed[edges[i].component] = 0;
    }
    return closed;
}

std::vector<double> enclosed_volumes(const Shell& shell) {
    // From the middle of the shell, so that nothing is lost to a far origin.
    const Box box = bounding_box(shell.positions);
    const Vec3 middle = (box.low + box.high) * 0.5;
    std::vector<double> volumes(shell.components.size(), 0);
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        const auto& [a, b, c] = shell.triangles[f];
        volumes[shell.component[f]] +=
            signed_volume(middle, shell.positions[a], shell.positions[b], shell.positions[c]);
    }
    for (double& volume : volumes) volume = std::fabs(volume);
    return volumes;
}

// Whether closed surfaces touch or run through each other along corners and edges that they share, where no triangle
// meets another's inside. Vertices of equal position count as one.
bool is_pinched(const Shell& shell) {
    std::map<std::array<double, 3>, Index> first_at;
    std::vector<Index> number;
    for (Index v = 0; v < shell.positions.size(); ++v) {
        const Vec3 p = shell.positions[v] + Vec3{};  // -0 + 0 = 0
        number.push_back(first_at.try_emplace({p.x, p.y, p.z}, v).first->second);
    }
    std::vector<Triangle> welded;
    for (const auto& [a, b, c] : shell.triangles) welded.push_back({number[a], number[b], number[c]});
    const NonManifold wrong = non_manifold(welded);
    return !wrong.edges.empty() || !wrong.vertices.empty();
}

bool has_material(const Shell& shell, Index component) {
    return component != none && shell.components[component].role != Role::cavity;
}

// The component that decides just outside component c, judged at one of its vertices; none in the open.
std::vector<Index> surroundings(const Shell& shell, const ShellInterior& interior) {
    std::vector<Index> vertex(shell.components.size(), none);
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) vertex[shell.component[f]] = shell.triangles[f][0];
    std::vector<Index> around(shell.components.size(), none);
    for (Index c = 0; c < around.size(); ++c) {
        if (vertex[c] != none) around[c] = interior.innermost(shell.positions[vertex[c]], c);
    }
    return around;
}

Index count_pieces(const Shell& shell, const std::vector<Index>& around,
                   const std::vector<MeetingTriangles>& meetings) {
    DisjointSets groups(shell.components.size());
    for (const MeetingTriangles& meeting : meetings) {
        const Index a = shell.component[meeting.first];
        const Index b = shell.component[meeting.second];
        if (has_material(shell, a) && has_material(shell, b)) groups.unite(a, b);
    }
    for (Index c = 0; c < around.size(); ++c) {
        if (has_material(shell, c) && has_material(shell, around[c])) groups.unite(c, around[c]);
    }
    std::set<Index> leaders;
    for (Index c = 0; c < around.size(); ++c) {
        if (has_material(shell, c)) leaders.insert(groups.find(c));
    }
    return static_cast<Index>(leaders.size());
}

}

ShellSolid study_solid(const Shell& shell, const ShellInterior& interior, const Context& context) {
    ShellSolid solid;
    solid.is_closed = closed_components(shell);
    solid.all_closed = std::find(solid.is_closed.begin(), solid.is_closed.end(), 0) == solid.is_closed.end();
    const std::vector<MeetingTriangles> meetings = self_intersections(shell.positions, shell.triangles, context);
    solid.has_meetings = !meetings.empty() || is_pinched(shell);
    const std::vector<Index> around = surroundings(shell, interior);
    const std::vector<double> volumes = enclosed_volumes(shell);
    for (Index c = 0; c < volumes.size(); ++c) {
        solid.volume += volumes[c] * (int{has_material(shell, c)} - int{has_material(shell, around[c])});
    }
    solid.pieces = count_pieces(shell, around, meetings);
    return solid;
}

}
