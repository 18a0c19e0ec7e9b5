// SPDX-License-Identifier: GPL-3.0-or-later
// Takes flaps off the surface: tets without thickness of which two faces or more show. Coplanar shell vertices, rounded
// to float, have such tets between two triangulations of their plane; which of them culling keeps is chance, and some
// are left as flaps over nothing.
#pragma once
#include <cstdint>

#include "core/context.h"
#include "finish/surface_guard.h"
#include "mesh/tet_mesh.h"

namespace crumple::finish {

// Thinner than this share of the shell's diagonal, and as flat as this shape, a tet is but rounding.
inline constexpr double no_thickness = 1e-5;
inline constexpr double no_shape = 1e-3;

// How many went; neighbours are filled again. A shell vertex never loses its last tet; a painted edge stays. May leave
// a surface that touches itself.
[[nodiscard]] std::uint64_t strip_flat_tets(TetMesh& mesh, const SurfaceGuard& guard, const Context& context);

}
