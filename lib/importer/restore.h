// SPDX-License-Identifier: GPL-3.0-or-later
// Puts back what assimp lost of a text file: exact numbers, and for OBJ the file's own vertex list.
#pragma once
#include "importer/prescan.h"
#include "importer/scene.h"

namespace crumple::importer {

// Where the two readings of the file do not match number by number, assimp's is kept and nothing is restored.
void restore(Prescan scan, Scene& scene);

}
