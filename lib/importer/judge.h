// SPDX-License-Identifier: GPL-3.0-or-later
// What a person should know about a finished shell, and what no later stage could work with.
#pragma once
#include <vector>

#include "core/context.h"
#include "core/finding.h"
#include "importer/import.h"
#include "importer/paint.h"
#include "importer/surface.h"
#include "mesh/shell.h"

namespace crumple::importer {

// Throws Error(bad_input) for more triangles than anybody simulates: asked before work begins.
void check_triangle_count(std::size_t count);

// Throws Error(bad_input) when the shell has no triangle, when its place leaves floats no digits for its shape, or when
// all its vertices lie in one plane (which a cage does not mind).
void check_usable(const Shell& shell, std::uint64_t file_triangles, double unit, bool is_caged = false);

// Pairs of triangles that meet, within a component and between two; components that enclose nothing.
[[nodiscard]] std::vector<Finding> judge_shape(const Shell& shell, const Context& context,
                                               std::uint64_t& intersections);

// Painted vertices of a vertex list that no face uses: a lock that would vanish without a word.
[[nodiscard]] std::vector<Finding> judge_unused_locks(const Scene& scene, const std::vector<Vec3>& vertex_list,
                                                      const std::vector<std::uint8_t>& is_used);

// A size that no vehicle or prop has: the file's unit was not what it was read as.
[[nodiscard]] std::vector<Finding> judge_size(double diagonal, const Placement& placement);

// A box so far from the origin that its floats are coarse.
[[nodiscard]] std::vector<Finding> judge_precision(const Shell& shell, double diagonal);

// Nothing locked, nearly everything locked, copies that disagree (an Error(bad_input) when params are strict).
[[nodiscard]] std::vector<Finding> judge_locks(const Shell& shell, const PaintedVertices& painted, Finding conflicts,
                                               const Params& params);

}
