// SPDX-License-Identifier: GPL-3.0-or-later
#include "finish/work_mesh.h"

#include <algorithm>

#include "geometry/predicates.h"
#include "mesh/boundary.h"

namespace crumple::finish {

WorkMesh::WorkMesh(const TetMesh& mesh)
    : complex(mesh), shapes(mesh.tets.size()), changed_at(mesh.positions.size(), 1), tried_at(mesh.tets.size(), 0) {
    for (Index t = 0; t < mesh.tets.size(); ++t) shapes[t] = shape_of(*this, mesh.tets[t]);
    find_surface(*this);
}

double shape_of(const WorkMesh& mesh, const Tet& tet) {
    return shape_of(mesh.at(tet[0]), mesh.at(tet[1]), mesh.at(tet[2]), mesh.at(tet[3]));
}

bool are_positive(const WorkMesh& mesh, std::span<const Tet> tets) {
    return std::all_of(tets.begin(), tets.end(), [&](const Tet& t) {
        return orient3d(mesh.at(t[0]), mesh.at(t[1]), mesh.at(t[2]), mesh.at(t[3])) > 0;
    });
}

double least_shape(const WorkMesh& mesh, std::span<const Index> tets) {
    double least = 1;
    for (const Index t : tets) least = std::min(least, mesh.shapes[t]);
    return least;
}

bool is_of_one_region(const WorkMesh& mesh, std::span<const Index> tets) {
    return std::all_of(tets.begin(), tets.end(),
                       [&](Index t) { return mesh.complex.region(t) == mesh.complex.region(tets[0]); });
}

std::span<const Index> apply(WorkMesh& mesh, const Exchange& exchange) {
    ++mesh.clock;
    const Index region = mesh.complex.region(exchange.old[0]);
    for (const Index t : exchange.old) {
        for (const Index v : mesh.complex.corners(t)) mesh.changed_at[v] = mesh.clock;
    }
    const std::span<const Index> fresh = mesh.complex.replace(exchange.old, exchange.fresh, region);
    mesh.shapes.resize(mesh.complex.slot_count());
    mesh.tried_at.resize(mesh.complex.slot_count());
    for (const Index t : fresh) {
        mesh.shapes[t] = shape_of(mesh, mesh.complex.corners(t));
        mesh.tried_at[t] = 0;
    }
    return fresh;
}

Index add_node(WorkMesh& mesh, Vec3 place) {
    mesh.is_on_surface.push_back(0);
    mesh.is_free.push_back(1);
    mesh.is_surplus.push_back(0);
    mesh.is_pinched.push_back(0);
    mesh.changed_at.push_back(mesh.clock + 1);
    return mesh.complex.add_node(place);
}

void move_node(WorkMesh& mesh, Index node, Vec3 place, std::span<const Index> star) {
    ++mesh.clock;
    mesh.complex.move_node(node, place);
    for (const Index t : star) {
        mesh.shapes[t] = shape_of(mesh, mesh.complex.corners(t));
        for (const Index v : mesh.complex.corners(t)) mesh.changed_at[v] = mesh.clock;
    }
}

void find_surface(WorkMesh& mesh) {
    const std::size_t nodes = mesh.complex.positions().size();
    mesh.is_on_surface.assign(nodes, 0);
    mesh.is_free.assign(nodes, 0);
    mesh.is_surplus.assign(nodes, 0);
    mesh.is_pinched.assign(nodes, 0);
    const TetMesh whole = mesh.complex.to_mesh();
    const Boundary boundary = boundary_of(whole);
    for (const Triangle& face : boundary.faces) {
        for (const Index v : face) mesh.is_on_surface[v] = 1;
    }
    for (const Index v : non_manifold(boundary.faces).vertices) mesh.is_pinched[v] = 1;
    std::vector<Index> region(nodes, none);
    std::vector<std::uint8_t> is_mixed(nodes, 0);
    for (std::size_t t = 0; t < whole.tets.size(); ++t) {
        const Index here = whole.region.empty() ? 0 : whole.region[t];
        for (const Index v : whole.tets[t]) {
            if (region[v] != none && region[v] != here) is_mixed[v] = 1;
            region[v] = here;
        }
    }
    for (std::size_t v = whole.shell_vertex_count; v < nodes; ++v) {
        if (is_mixed[v] || mesh.is_pinched[v] || region[v] == none) continue;
        (mesh.is_on_surface[v] ? mesh.is_surplus : mesh.is_free)[v] = 1;
    }
}

TetMesh take_mesh(const WorkMesh& mesh) {
    TetMesh result = mesh.complex.to_mesh();
    std::vector<Index> number(result.positions.size(), none);
    for (const Tet& tet : result.tets) {
        for (const Index v : tet) number[v] = 0;
    }
    Index count = 0;
    for (Index v = 0; v < result.positions.size(); ++v) {
        if (number[v] == none && v >= result.shell_vertex_count) continue;
        result.positions[count] = result.positions[v];
        number[v] = count++;
    }
    result.positions.resize(count);
    for (Tet& tet : result.tets) {
        for (Index& v : tet) v = number[v];
    }
    return result;
}

}
