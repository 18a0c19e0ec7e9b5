// SPDX-License-Identifier: MIT
// The tets as a VTK XML unstructured grid, in plain text: for tools that do not read VTKHDF.
#pragma once
#include <string>

#include "bundle/bundle.h"

namespace crumple::store {

// Point data locked and mass, cell data region, material, volume and stiffness_scale. Numbers read back exactly.
[[nodiscard]] std::string export_vtu(const Bundle& bundle);

}
