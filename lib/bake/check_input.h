// SPDX-License-Identifier: GPL-3.0-or-later
// Work files can come from anywhere: bake's inputs must fit each other before anything is indexed with them.
#pragma once
#include "mesh/asset.h"
#include "mesh/bindings.h"
#include "mesh/tet_mesh.h"

namespace crumple::bake {

// Throws Error(bad_input) that names the first array or element that does not fit.
void check_input(const Asset& asset, const TetMesh& mesh, const Bindings& bindings);

}
