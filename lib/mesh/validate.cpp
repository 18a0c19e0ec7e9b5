// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/validate.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <span>

#include "core/error.h"
#include "geometry/predicates.h"
#include "mesh/neighbours.h"

namespace crumple {

namespace {

class Findings {
public:
    void add(std::string code, std::string message) {
        list.push_back({std::move(code), Severity::error, std::move(message), 1, {}});
    }

    // One finding for all of `count` elements that `is_wrong` names, with the first few.
    void add_each(std::string code, std::string message, std::size_t count,
                  const std::function<bool(Index)>& is_wrong) {
        Finding finding{std::move(code), Severity::error, std::move(message), 0, {}};
        for (Index i = 0; i < count; ++i) {
            if (is_wrong(i)) count_one(finding, {{}, i, {}});
        }
        if (finding.count > 0) list.push_back(std::move(finding));
    }

    std::vector<Finding> list;
};

template <std::size_t N>
bool is_simplex(const std::array<Index, N>& corners, std::size_t vertex_count) {
    for (std::size_t i = 0; i < N; ++i) {
        if (corners[i] >= vertex_count) return false;
        for (std::size_t j = 0; j < i; ++j) {
            if (corners[i] == corners[j]) return false;
        }
    }
    return true;
}

void check_components(Findings& findings, const Shell& shell) {
    std::set<std::string> names;
    const auto& components = shell.components;
    findings.add_each("SHELL_COMPONENT_NAME", "component names must be unique", components.size(),
                      [&](Index c) { return !names.insert(components[c].name).second; });
    findings.add_each("SHELL_COMPONENT_PARENT", "a component's parent must be another component", components.size(),
                      [&](Index c) {
                          return components[c].parent != none &&
                                 (components[c].parent >= components.size() || components[c].parent == c);
                      });
    if (shell.component.size() != shell.triangles.size()) {
        return findings.add("SHELL_SIZES", "component must have one entry a triangle");
    }
    findings.add_each("SHELL_COMPONENT_INDEX", "triangles refer to a component that is not there",
                      shell.component.size(), [&](Index f) { return shell.component[f] >= components.size(); });
}

// Positive tets whose corners exist; otherwise there is no point in looking further.
bool check_tets(Findings& findings, const TetMesh& mesh) {
    const auto& p = mesh.positions;
    findings.add_each("TETS_CORNERS", "tets refer to nodes that are not there, or to one twice", mesh.tets.size(),
                      [&](Index t) { return !is_simplex(mesh.tets[t], p.size()); });
    findings.add_each("TETS_ORIENTATION", "tets are flat or inside out", mesh.tets.size(), [&](Index t) {
        const auto& [a, b, c, d] = mesh.tets[t];
        return is_simplex(mesh.tets[t], p.size()) && orient3d(p[a], p[b], p[c], p[d]) <= 0;
    });
    return findings.list.empty();
}

void check_neighbours(Findings& findings, const TetMesh& mesh) {
    std::vector<std::array<Index, 4>> expected;
    try {
        expected = neighbours_of(mesh.tets);
    } catch (const Error&) {
        return findings.add("TETS_FACES", "more than two tets share a face");
    }
    if (mesh.neighbours.size() != mesh.tets.size())
        return findings.add("TETS_SIZES", "neighbours must have one entry a tet");
    findings.add_each("TETS_NEIGHBOURS", "neighbours do not fit the corners", mesh.tets.size(),
                      [&](Index t) { return mesh.neighbours[t] != expected[t]; });
}

}

std::vector<Finding> validate(const Shell& shell) {
    Findings findings;
    const std::size_t vertex_count = shell.positions.size();
    findings.add_each("SHELL_POSITION", "positions must be finite floats", vertex_count,
                      [&](Index v) { return !is_float(shell.positions[v]); });
    findings.add_each("SHELL_CORNERS", "triangles refer to vertices that are not there, or to one twice",
                      shell.triangles.size(), [&](Index f) { return !is_simplex(shell.triangles[f], vertex_count); });
    if (!shell.color.empty() && shell.color.size() != vertex_count)
        findings.add("SHELL_SIZES", "color must be empty or have one entry a vertex");
    if (shell.locked.size() != vertex_count) findings.add("SHELL_SIZES", "locked must have one entry a vertex");
    if (shell.source_vertex.size() != vertex_count)
        findings.add("SHELL_SIZES", "source_vertex must have one entry a vertex");
    check_components(findings, shell);
    return findings.list;
}

std::vector<Finding> validate(const TetMesh& mesh, Index component_count) {
    Findings findings;
    findings.add_each("TETS_POSITION", "positions must be finite floats", mesh.positions.size(),
                      [&](Index v) { return !is_float(mesh.positions[v]); });
    if (mesh.shell_vertex_count > mesh.positions.size())
        findings.add("TETS_SIZES", "there are fewer nodes than shell vertices");
    if (check_tets(findings, mesh)) check_neighbours(findings, mesh);
    if (!mesh.region.empty() && mesh.region.size() != mesh.tets.size()) {
        findings.add("TETS_SIZES", "region must be empty or have one entry a tet");
    }
    findings.add_each("TETS_REGION", "tets lie in a shell component that is not there", mesh.region.size(),
                      [&](Index t) { return component_count != none && mesh.region[t] >= component_count; });
    return findings.list;
}

}
