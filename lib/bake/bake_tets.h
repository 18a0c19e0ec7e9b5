// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the tets and their corners, and the numbers of their rest state.
#pragma once
#include <array>

#include "bake/choose_materials.h"

namespace crumple::bake {

// Bundle tet t is mesh tet mesh_tet[t]; its corner k is that tet's corner corners[t][k].
struct TetOrder {
    std::vector<Index> mesh_tet;
    std::vector<std::array<std::uint8_t, 4>> corners;
};

// Fills tets and solver_tet_count. Corners begin with the lowest node and stay positive; tets with a free node come
// first, each part in lexicographic order of its tets.
// REQUIRES: bake_nodes has filled the nodes.
[[nodiscard]] TetOrder bake_tets(const TetMesh& mesh, Bundle& bundle);

// Fills inverse_rest, volume, stiffness_scale, material, region, materials, regions and mass.
// Throws Error(bad_input) when a number of a tet does not fit into a float.
void bake_rest_state(const Shell& shell, const TetMesh& mesh, const TetOrder& order, const Params& params,
                     const std::vector<ComponentMaterial>& component_materials, Bundle& bundle, Report& report);

}
