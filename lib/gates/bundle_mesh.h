// SPDX-License-Identifier: GPL-3.0-or-later
// A bundle in the form that offline modules measure: double, with neighbours, in the bundle's own order.
#pragma once
#include "bundle/bundle.h"
#include "mesh/bindings.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"

namespace crumple::gates {

// REQUIRES of them all: the bundle is valid.
[[nodiscard]] TetMesh mesh_of(const Bundle& bundle);
[[nodiscard]] Bindings bindings_of(const Bundle& bundle);

// The shell over the bundle's nodes: vertex numbers become node numbers. Its vertices that the bundle does not have
// come last, in both positions.
[[nodiscard]] Shell shell_over(const Bundle& bundle, const Shell& shell, TetMesh& mesh);

}
