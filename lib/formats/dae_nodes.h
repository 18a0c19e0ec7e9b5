// SPDX-License-Identifier: GPL-3.0-or-later
// How a COLLADA file places its meshes: nodes, nodes drawn in other nodes, and the unit.
#pragma once
#include "formats/dae_document.h"

namespace crumple::formats::dae {

// Transforms are as many finite numbers as their kind has, no node is drawn within itself, and the scene with all that
// is drawn twice unfolded stays of a size that can be read. Throws Error(bad_input).
void check_nodes(const Document& document);

// The unit is a length. Throws Error(bad_input).
void check_unit(const Document& document);

}
