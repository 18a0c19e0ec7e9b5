// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the meshes of a COLLADA file say the same thing twice. assimp believes one of two counts that differ, takes a
// negative index for 0, reads past the end of an array, and fills all memory for a word that is no index.
#pragma once
#include "formats/dae_document.h"
#include "formats/prescan.h"

namespace crumple::formats::dae {

// Arrays hold as many numbers as they announce, accessors of positions and of a shell's colours stay within them, `<p>`
// holds indices of what is there, as many as the primitive announces. Throws Error(bad_input).
void check_meshes(const Document& document, Purpose purpose);

}
