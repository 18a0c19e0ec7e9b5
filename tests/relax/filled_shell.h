// SPDX-License-Identifier: GPL-3.0-or-later
// The two stages before relax, for tests that need their result.
#pragma once
#include <string>
#include <vector>

#include "delaunay/delaunay.h"
#include "sample/sample.h"

namespace crumple::shapes {

inline TetMesh filled(const Shell& shell, std::string count = "auto", sample::Method method = sample::Method::uniform) {
    sample::Params params;
    params.points = std::move(count);
    params.method = method;
    return delaunay::tetrahedralize(sample::sample_interior(shell, params).points).mesh;
}

inline std::vector<Vec3> interior_of(const TetMesh& mesh) {
    return {mesh.positions.begin() + mesh.shell_vertex_count, mesh.positions.end()};
}

}
