// SPDX-License-Identifier: GPL-3.0-or-later
// Puts back what assimp lost of a file: numbers of text to the last bit, for OBJ the file's own vertex list, for glTF
// the double precision of node transforms.
#pragma once
#include "formats/prescan.h"
#include "importer/scene.h"

namespace crumple::importer {

// Throws Error(bad_input) where the two readings of an OBJ, PLY or OFF file do not match number by number: assimp has
// lost its place in the file, and with it locks.
void restore(formats::Prescan scan, Scene& scene);

}
