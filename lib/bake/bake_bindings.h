// SPDX-License-Identifier: GPL-3.0-or-later
// Bindings in the bundle's order of tets and corners, by vertex and by tet.
#pragma once
#include "bake/bake_tets.h"

namespace crumple::bake {

[[nodiscard]] std::vector<BundleVisual> bake_bindings(const Bindings& bindings, const TetOrder& order);

}
