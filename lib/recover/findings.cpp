// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/findings.h"

#include <string>

#include "recover/crossings.h"

namespace crumple::recover {

namespace {

std::string component_of(const Evidence& evidence, Index shell_triangle) {
    return evidence.shell.components[evidence.shell.component[shell_triangle]].name;
}

// A shell triangle at a segment.
Index origin_at(const Evidence& evidence, const Edge& segment) {
    return evidence.constraints.origin(
        sorted_triangle(segment[0], segment[1], evidence.constraints.apexes(segment).front()));
}

void add_place(Finding& finding, const Evidence& evidence, Vec3 position, Index shell_triangle) {
    if (wants_place(finding))
        finding.places.push_back({position, shell_triangle, component_of(evidence, shell_triangle)});
}

// A shell triangle that runs through a missing edge or triangle, none when there is none.
Index blocker_of(const Evidence& evidence, const Edge& segment) {
    std::vector<Crossing> crossings;
    crossings_of_segment(evidence.complex, segment[0], segment[1], crossings);
    for (const Crossing& c : crossings) {
        if (c.count == 3 && evidence.constraints.has_facet(c.nodes[0], c.nodes[1], c.nodes[2]))
            return evidence.constraints.origin(sorted_triangle(c.nodes[0], c.nodes[1], c.nodes[2]));
        if (c.count == 2 && evidence.constraints.has_segment(c.nodes[0], c.nodes[1]))
            return origin_at(evidence, sorted_edge(c.nodes[0], c.nodes[1]));
    }
    return none;
}

Index blocker_of(const Evidence& evidence, const Triangle& facet) {
    FacetObstacles obstacles;
    obstacles_of_any_facet(evidence.complex, facet, obstacles);
    for (const PiercingEdge& e : obstacles.edges) {
        if (evidence.constraints.has_segment(e.nodes[0], e.nodes[1])) return origin_at(evidence, e.nodes);
    }
    return none;
}

// Says what runs through where it is known.
template <class Nodes>
void name_blocker(Finding& finding, std::size_t place, const Evidence& evidence, const Nodes& nodes) {
    if (place >= finding.places.size()) return;
    const Index blocker = blocker_of(evidence, nodes);
    if (blocker == none) return;
    finding.places[place].name +=
        ", crossed by triangle " + std::to_string(blocker) + " of " + component_of(evidence, blocker);
}

// Edges and triangles that are missing for one reason, by their middle and a shell triangle.
Finding missing_finding(std::string code, std::string message, const Evidence& evidence, const std::vector<Edge>& edges,
                        const std::vector<Triangle>& triangles) {
    Finding finding{std::move(code), Severity::warning, std::move(message), edges.size() + triangles.size(), {}};
    const auto at = [&](Index v) { return evidence.complex.position(v); };
    for (const Edge& e : edges) add_place(finding, evidence, (at(e[0]) + at(e[1])) * 0.5, origin_at(evidence, e));
    for (const Triangle& t : triangles)
        add_place(finding, evidence, (at(t[0]) + at(t[1]) + at(t[2])) / 3, evidence.constraints.origin(t));
    return finding;
}

}

std::vector<Finding> describe_findings(const Evidence& evidence) {
    std::vector<Finding> findings;
    const auto keep = [&](Finding finding) {
        if (finding.count > 0) findings.push_back(std::move(finding));
    };
    Finding blocked = missing_finding(
        "RECOVER_BLOCKED",
        "edges and triangles of the shell that other parts of it run through: they cannot all be faces "
        "of tets, so the winding number decides what is inside there; move the parts aside or unite them",
        evidence, evidence.edges.blocked, evidence.triangles.blocked);
    for (std::size_t i = 0; i < evidence.edges.blocked.size() && i < max_places; ++i)
        name_blocker(blocked, i, evidence, evidence.edges.blocked[i]);
    for (std::size_t i = 0; i < evidence.triangles.blocked.size() && i < max_places; ++i)
        name_blocker(blocked, evidence.edges.blocked.size() + i, evidence, evidence.triangles.blocked[i]);
    keep(std::move(blocked));
    keep(missing_finding(
        "RECOVER_STUCK",
        "edges and triangles of the shell that could not be brought back, so the winding number decides "
        "what is inside there; raise max_steiner or budget, or use rounder triangles",
        evidence, evidence.edges.stuck, evidence.triangles.stuck));
    Finding steiner{
        "RECOVER_STEINER",
        Severity::info,
        "nodes that had to be put on edges and triangles of the shell; they lie on it to the last digit of a "
        "float",
        evidence.splits.size(),
        {}};
    for (const Split& split : evidence.splits)
        add_place(steiner, evidence, evidence.complex.position(split.node), split.origins.front());
    keep(std::move(steiner));
    return findings;
}

}
