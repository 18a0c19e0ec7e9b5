// SPDX-License-Identifier: MIT
#define CRUMPLE_LANES scalar
// The lanes come first: the kernels below are written in their terms.
#include "solver/lanes_scalar.h"

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

const Kernels scalar_kernels = {scalar::step_elements,
                                scalar::elastic_energies,
                                scalar::extract_rotations,
                                scalar::gather_loads,
                                scalar::assemble_edges,
                                scalar::finish_rows,
                                scalar::multiply,
                                scalar::product_dot,
                                scalar::start,
                                scalar::descend,
                                scalar::turn,
                                scalar::skin_vertices,
                                scalar::multiply_modes,
                                scalar::dot_modes,
                                scalar::mode_energies,
                                scalar::subtract_motion};

}
