// SPDX-License-Identifier: GPL-3.0-or-later
// Which nodes of a glTF file are read: those of the scene it says, of its first one, or all of them where it has none.
#pragma once
#include <cstddef>
#include <set>

#include "formats/gltf_document.h"
#include "formats/unread.h"

namespace crumple::formats::gltf {

// A node has one parent at most, none is above itself, scenes name nodes and nodes name meshes that are there. Throws
// Error(bad_input).
void check_nodes(const Json& document);

// Makes the document say which scene is read, and tells how many nodes with a mesh are outside it. The meshes within.
// Throws Error(bad_input) when there are none of these but others. REQUIRES: check_nodes.
std::set<std::size_t> choose_scene(Json& document, Unread& unread);

}
