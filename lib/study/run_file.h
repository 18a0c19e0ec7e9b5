// SPDX-License-Identifier: GPL-3.0-or-later
// A run in files: one with all numbers, and a series for ParaView, a VTKHDF file a frame and mesh with an index beside.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "bundle/bundle.h"
#include "study/run.h"
#include "study/scene.h"

namespace crumple::study {

// Triangles of the visual meshes, in the bundle's order; a list may be empty, then vertices are drawn as points.
using VisualTriangles = std::vector<std::vector<Triangle>>;

// All of the run: /run/time_s and what else a frame has, F of each; /run/nodes and /run/visual/<name>, rows F N;
// sensors; the scene as JSON. /VTKHDF shows the last frame. Same run, same bytes.
[[nodiscard]] std::vector<std::byte> run_image(const Bundle& bundle, const Scene& scene, const Run& run);

// The control mesh with plastic strain, or one visual mesh, at one frame: what ParaView opens.
[[nodiscard]] std::vector<std::byte> control_image(const Bundle& bundle, const Frame& frame);
[[nodiscard]] std::vector<std::byte> visual_image(const Frame& frame, std::size_t visual,
                                                  const std::vector<Triangle>& triangles);

struct SeriesFile {
    std::string name;  // beside the index
    double time_s;
};
// The index: ParaView's "<name>.hdf.series".
[[nodiscard]] std::string series_index(const std::vector<SeriesFile>& files);

}
