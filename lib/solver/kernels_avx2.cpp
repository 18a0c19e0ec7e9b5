// SPDX-License-Identifier: MIT
#define CRUMPLE_LANES avx2
// The lanes come first: the kernels below are written in their terms.
#include "solver/lanes_avx2.h"

#include "solver/degenerate.h"
#include "solver/element_lane.h"
#include "solver/kernels.h"

#include "solver/kernel_rotation.h"

#include "solver/kernel_strain.h"

#include "solver/kernel_elements.h"
#include "solver/kernel_matrix.h"
#include "solver/kernel_modes.h"
#include "solver/kernel_nodes.h"
#include "solver/kernel_skin.h"

namespace crumple::solver {

const Kernels avx2_kernels = {
    avx2::step_elements,  avx2::elastic_energies, avx2::extract_rotations, avx2::gather_loads, avx2::assemble_edges,
    avx2::finish_rows,    avx2::multiply,         avx2::product_dot,       avx2::start,        avx2::descend,
    avx2::turn,           avx2::skin_vertices,    avx2::multiply_modes,    avx2::dot_modes,    avx2::mode_energies,
    avx2::subtract_motion};

}
