// SPDX-License-Identifier: MIT
#define CRUMPLE_LANES avx512
// The lanes come first: the kernels below are written in their terms.
#include "solver/lanes_avx512.h"

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

const Kernels avx512_kernels = {avx512::step_elements,
                                avx512::elastic_energies,
                                avx512::extract_rotations,
                                avx512::gather_loads,
                                avx512::assemble_edges,
                                avx512::finish_rows,
                                avx512::multiply,
                                avx512::product_dot,
                                avx512::start,
                                avx512::descend,
                                avx512::turn,
                                avx512::skin_vertices,
                                avx512::multiply_modes,
                                avx512::dot_modes,
                                avx512::mode_energies,
                                avx512::subtract_motion};

}
