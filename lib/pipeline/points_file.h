// SPDX-License-Identifier: GPL-3.0-or-later
// Points as text: what `crumple delaunay` takes besides a work file.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "mesh/point_set.h"

namespace crumple::pipeline {

// By extension: xyz, txt, pts, csv, tsv, obj (its v lines), node (TetGen).
[[nodiscard]] bool is_points_file(const std::string& path);

// The numbers of the file as doubles, as they are; none of the points is the shell's.
// Throws Error(file) when it cannot be read, Error(bad_input) that names the first line that is not x y z.
[[nodiscard]] PointSet read_points_file(const std::string& path);

// The same from text. A line holds x, y, z; blank lines, lines that start with # and one heading are
// skipped; a first line of one number is the count and must be right. Separators: blanks, tabs, commas, semicolons.
[[nodiscard]] PointSet parse_points(std::string_view text, std::string_view source);
[[nodiscard]] PointSet parse_obj_points(std::string_view text, std::string_view source);
[[nodiscard]] PointSet parse_node_points(std::string_view text, std::string_view source);

}
