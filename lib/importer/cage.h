// SPDX-License-Identifier: GPL-3.0-or-later
// A lattice around a shell that is no surface of anything: what an artist has left when a visual mesh is all there is.
// The lattice deforms; the visual meshes hang in it.
#pragma once
#include <cstdint>
#include <vector>

#include "core/context.h"
#include "core/finding.h"
#include "mesh/asset.h"

namespace crumple::importer {

// Replaces asset.shell by the surface of all lattice tets that a triangle of it passes through, that hold a vertex of a
// visual mesh, that the outside cannot be reached from, or whose middle has a winding number above 0.5. The surface is
// closed and manifold; nodes within it are vertices of the shell without a triangle, so that the Delaunay tets of the
// shell's vertices are those of the lattice. Every node of a tet that holds a locked vertex is locked, so what was
// painted stays where it was. Roles, names and colours of the components are lost: the finding IMPORT_CAGED says so.
[[nodiscard]] Finding put_in_cage(Asset& asset, std::uint32_t cells, const Context& context = {});

}
