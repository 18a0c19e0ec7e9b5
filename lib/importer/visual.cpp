// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/visual.h"

#include <numeric>

namespace crumple::importer {

VisualMesh make_visual(const std::string& name, const Surface& surface, std::vector<Vec3> vertex_list) {
    VisualMesh mesh;
    mesh.name = name;
    if (!surface.has_vertex_list) {
        mesh.positions = surface.positions;
        mesh.triangles = surface.triangles;
        mesh.source_vertex = surface.source_vertex;
        return mesh;
    }
    mesh.positions = std::move(vertex_list);
    mesh.source_vertex.resize(mesh.positions.size());
    std::iota(mesh.source_vertex.begin(), mesh.source_vertex.end(), 0u);
    for (const Triangle& t : surface.triangles) {
        mesh.triangles.push_back(
            {surface.source_vertex[t[0]], surface.source_vertex[t[1]], surface.source_vertex[t[2]]});
    }
    return mesh;
}

}
