// SPDX-License-Identifier: GPL-3.0-or-later
// From what a file holds to a judged shell: place, read the paint, weld, clean, split, name, judge.
#pragma once
#include <string>

#include "core/context.h"
#include "formats/format.h"
#include "importer/import.h"
#include "importer/scene.h"
#include "mesh/shell.h"

namespace crumple::importer {

// Fills report but for its visuals. fallback_name serves what the file does not name.
// Throws Error(bad_input) when no later stage could work with the result, or params are strict about it.
[[nodiscard]] Shell shell_from_scene(const Scene& scene, const formats::Format& format,
                                     const std::string& fallback_name, const Params& params, const Context& context,
                                     Report& report);

}
