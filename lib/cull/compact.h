// SPDX-License-Identifier: GPL-3.0-or-later
// Leaves the chosen tets of a mesh and the nodes they use.
#pragma once
#include <span>

#include "core/index.h"
#include "mesh/tet_mesh.h"

namespace crumple::cull {

// region: T of the incoming tets, none for those that go. Shell vertices stay even where no tet uses them; interior
// nodes in use move down in their order, so the order of tets and of corners stays canonical.
[[nodiscard]] TetMesh compact(TetMesh mesh, std::span<const Index> region);

}
