// SPDX-License-Identifier: GPL-3.0-or-later
// Holds every figure of a mesh against its limits, and tells the artist where it falls short and what to try.
#pragma once
#include <vector>

#include "core/finding.h"
#include "gates/limits.h"
#include "mesh/shell.h"
#include "mesh/tet_mesh.h"
#include "quality/figures.h"
#include "quality/place_teller.h"

namespace crumple::gates {

// One finding a gate that is not met, in the order of Limits: Severity::error where it fails, else warning. Codes
// GATE_*. Places are the worst first, each with its figure, component, material and nearest painted vertex in the name.
// Tets of no volume fail whatever the parameters (GATE_INVERTED). Nothing to say about a mesh without tets.
// `shell` and `embedding` may be null: then the surface of the tets stands for the shell, and vertices have no places.
// REQUIRES: figures of this mesh; mesh.neighbours is filled.
[[nodiscard]] std::vector<Finding> judge(const quality::Figures& figures, const TetMesh& mesh, const Shell* shell,
                                         const Limits& limits = {}, const quality::PlaceNames& names = {},
                                         const quality::EmbeddingResult* embedding = nullptr);

}
