// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs every vertex of the visual meshes on the tet that contains it, else on the nearest.
#pragma once
#include <span>
#include <vector>

#include "core/context.h"
#include "core/fields.h"
#include "core/finding.h"
#include "mesh/bindings.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"
#include "mesh/visual_mesh.h"

namespace crumple::bind {

inline constexpr int version = 1;

struct Params {};
struct Report {};

struct Result {
    Bindings bindings;  // one per visual mesh, in their order
    Report report;
};

[[nodiscard]] Result bind_visuals(const Shell& shell, const TetMesh& mesh, std::span<const VisualMesh> visuals,
                                  const Params& params = {}, const Context& context = {});

}
