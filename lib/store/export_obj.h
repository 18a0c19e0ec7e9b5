// SPDX-License-Identifier: MIT
// The boundary of the tets as a Wavefront OBJ with locks as vertex colours, as an artist would paint them: red 0 where
// locked. Importing it again locks the same positions.
#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "bundle/bundle.h"

namespace crumple::store {

// Locked nodes inside the boundary follow as points. Locked: 0 0 1, free: 1 1 1. Numbers read back exactly.
[[nodiscard]] std::string export_obj(const Bundle& bundle);

// The same of any surface. Vertices that no face uses and that are not locked are left out.
[[nodiscard]] std::string export_surface_obj(std::span<const Vec3f> positions, std::span<const std::uint8_t> locked,
                                             std::span<const Triangle> faces);

}
