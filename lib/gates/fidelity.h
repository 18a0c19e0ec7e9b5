// SPDX-License-Identifier: GPL-3.0-or-later
// How well the tets keep to the artist's shell.
#pragma once
#include "gates/gates.h"
#include "mesh/tet_mesh.h"

namespace crumple::gates {

struct Measured {
    quality::Fidelity fidelity;
    std::uint64_t shell_pieces = 0;
};

// REQUIRES: mesh.neighbours is filled.
[[nodiscard]] Measured measure_fidelity(const Shell& shell, const TetMesh& mesh, const Solid& solid,
                                        std::uint32_t samples, const Context& context);

}
