// SPDX-License-Identifier: GPL-3.0-or-later
// A run as one glTF 2.0 binary that any viewer plays: every mesh at the first frame, a morph target for each later one,
// and an animation that fades from one to the next [Khronos Group 2021, glTF 2.0 specification, 3.7.2.2 and 3.11].
#pragma once
#include <string>

#include "study/run_file.h"

namespace crumple::study {

// Viewers hold all targets in memory: of a longer run evenly spaced frames are taken.
inline constexpr std::size_t max_morph_targets = 60;

// Visual meshes that have triangles; where none has, the boundary of the control mesh. Same run, same bytes.
[[nodiscard]] std::string run_glb(const Bundle& bundle, const Run& run, const VisualTriangles& triangles);

}
