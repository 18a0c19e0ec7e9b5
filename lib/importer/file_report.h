// SPDX-License-Identifier: GPL-3.0-or-later
// What a file held, and what was lost before we saw it.
#pragma once
#include <string>
#include <vector>

#include "core/finding.h"
#include "formats/format.h"
#include "importer/import.h"
#include "importer/scene.h"
#include "importer/surface.h"

namespace crumple::importer {

[[nodiscard]] FileReport report_file(const std::string& name, const formats::Format& format, const Placement& placement,
                                     const Scene& scene, const Surface& surface);

// Faces the reader did not deliver, points and lines dropped, parts of the file that are not read.
[[nodiscard]] std::vector<Finding> judge_reading(const Scene& scene, const FileReport& report);

// Colours that are not a vertex's, where the file paints no vertex.
[[nodiscard]] std::vector<Finding> judge_other_paint(const formats::Unread& unread, std::size_t color_set_count);

// Programs known to write other colours than those painted.
[[nodiscard]] std::vector<Finding> judge_generator(const Scene& scene, std::size_t color_set_count);

}
