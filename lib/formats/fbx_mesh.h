// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the meshes of an FBX file hold what they announce. assimp leaves out a mesh whose polygons do not fit and a
// colour layer that it does not know or whose count differs, without a word.
#pragma once
#include "formats/fbx_document.h"
#include "formats/prescan.h"

namespace crumple::formats::fbx {

// Polygons end, and name vertices that are there. A shell's colour layers are mapped in a way that is read and hold a
// colour for each vertex or corner; those of faces are counted. Throws Error(bad_input).
void check_meshes(const Document& document, Purpose purpose, Unread& unread);

}
