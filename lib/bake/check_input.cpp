// SPDX-License-Identifier: GPL-3.0-or-later
#include "bake/check_input.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "bundle/exact_volume.h"
#include "core/error.h"

namespace crumple::bake {
namespace {

void require(bool condition, const std::string& what) {
    if (!condition) throw Error(ErrorKind::bad_input, "bake: " + what);
}

void check_shell(const Shell& shell) {
    const std::size_t vertex_count = shell.positions.size();
    require(shell.locked.size() == vertex_count, "the shell needs one lock flag a vertex");
    require(shell.color.empty() || shell.color.size() == vertex_count, "the shell needs one colour a vertex, or none");
    require(shell.component.size() == shell.triangles.size(), "the shell needs one component number a triangle");
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        const Triangle& corners = shell.triangles[f];
        require(*std::max_element(corners.begin(), corners.end()) < vertex_count &&
                    shell.component[f] < shell.components.size(),
                "shell triangle " + std::to_string(f) + " names a vertex or component that does not exist");
    }
}

void check_mesh(const Shell& shell, const TetMesh& mesh) {
    require(mesh.shell_vertex_count == shell.positions.size() && mesh.positions.size() >= shell.positions.size() &&
                mesh.positions.size() < none,
            "the mesh does not begin with the shell's vertices; run the stages before it on this shell");
    require(!mesh.tets.empty(), "the mesh has no tets");
    require(mesh.tets.size() < none, "the mesh has more tets than 32-bit indices can name");
    require(mesh.region.empty() || mesh.region.size() == mesh.tets.size(), "the mesh needs one region a tet");
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        require(is_float(mesh.positions[v]), "node " + std::to_string(v) + " lies where no float does");
        require(v >= shell.positions.size() || mesh.positions[v] == shell.positions[v],
                "node " + std::to_string(v) + " is not where the shell's vertex is");
    }
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        const Tet& tet = mesh.tets[t];
        require(*std::max_element(tet.begin(), tet.end()) < mesh.positions.size(),
                "tet " + std::to_string(t) + " names a node that does not exist");
        require(mesh.region.empty() || mesh.region[t] < std::max<std::size_t>(1, shell.components.size()),
                "tet " + std::to_string(t) + " lies in a component that does not exist");
        require(six_volumes(narrow(mesh.positions[tet[0]]), narrow(mesh.positions[tet[1]]),
                            narrow(mesh.positions[tet[2]]), narrow(mesh.positions[tet[3]])) > 0,
                "tet " + std::to_string(t) + " is flat or inside out");
    }
}

void check_binding(const VisualBinding& binding, std::size_t tet_count) {
    const std::size_t vertex_count = binding.tet.size();
    require(binding.barycentric.size() == vertex_count && binding.inside.size() == vertex_count &&
                binding.distance.size() == vertex_count && vertex_count < none,
            "the bindings of '" + binding.name + "' differ in length");
    for (std::size_t v = 0; v < vertex_count; ++v) {
        const auto& weights = binding.barycentric[v];
        const bool is_finite =
            std::all_of(weights.begin(), weights.end(), [](double w) { return std::fabs(w) < 1e30; });
        require(binding.tet[v] < tet_count && is_finite && binding.distance[v] >= 0 && binding.distance[v] < 1e30,
                "vertex " + std::to_string(v) + " of visual mesh '" + binding.name +
                    "' is bound to no tet, or lies too far from all of them; is the mesh in the shell's unit (--unit) "
                    "and place?");
    }
}

}

void check_input(const Asset& asset, const TetMesh& mesh, const Bindings& bindings) {
    check_shell(asset.shell);
    check_mesh(asset.shell, mesh);
    std::set<std::string> names;
    for (const VisualBinding& binding : bindings) {
        require(!binding.name.empty() && names.insert(binding.name).second,
                "visual meshes need names of their own, '" + binding.name + "' is empty or used twice");
        check_binding(binding, mesh.tets.size());
    }
}

}
