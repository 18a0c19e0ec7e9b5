// SPDX-License-Identifier: MIT
// A model as the bytes of a file. Same model, same bytes.
#pragma once
#include <string>

#include "samples/model.h"

namespace crumple::samples {

// Wavefront OBJ: one object a part, `v x y z r g b` with colours from 0 to 1 where the part has colours.
[[nodiscard]] std::string obj_bytes(const Model& model);

// Binary little-endian PLY: all parts in one vertex list, since PLY knows no objects. Colours are uchar RGBA.
[[nodiscard]] std::string ply_bytes(const Model& model);

// glTF 2.0 binary: one node and mesh a part, POSITION as float, COLOR_0 as normalized bytes, 32-bit indices.
[[nodiscard]] std::string glb_bytes(const Model& model);

}
