// SPDX-License-Identifier: GPL-3.0-or-later
#include "recover/findings.h"

#include <string>

namespace crumple::recover {

namespace {

std::string component_of(const Evidence& evidence, Index shell_triangle) {
    return evidence.shell.components[evidence.shell.component[shell_triangle]].name;
}

void add_place(Finding& finding, const Evidence& evidence, Vec3 position, Index shell_triangle) {
    if (finding.places.size() < max_places)
        finding.places.push_back({position, shell_triangle, component_of(evidence, shell_triangle)});
}

// Edges and triangles that are missing for one reason, by their middle and a shell triangle.
Finding missing_finding(std::string code, std::string message, const Evidence& evidence, const std::vector<Edge>& edges,
                        const std::vector<Triangle>& triangles) {
    Finding finding{std::move(code), Severity::warning, std::move(message), edges.size() + triangles.size(), {}};
    const auto at = [&](Index v) { return evidence.complex.position(v); };
    for (const Edge& e : edges) {
        const Triangle facet = sorted_triangle(e[0], e[1], evidence.constraints.apexes(e).front());
        add_place(finding, evidence, (at(e[0]) + at(e[1])) * 0.5, evidence.constraints.origin(facet));
    }
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
    keep(missing_finding(
        "RECOVER_BLOCKED",
        "edges and triangles of the shell that other parts of it run through: they cannot all be faces "
        "of tets, so the winding number decides what is inside there; move the parts aside or unite them",
        evidence, evidence.edges.blocked, evidence.triangles.blocked));
    keep(missing_finding(
        "RECOVER_STUCK",
        "edges and triangles of the shell that could not be brought back, so the winding number decides "
        "what is inside there; raise max_steiner or use rounder triangles",
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
