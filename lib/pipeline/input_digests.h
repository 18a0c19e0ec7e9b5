// SPDX-License-Identifier: GPL-3.0-or-later
// What a bundle remembers of its inputs: their content, never where they lay.
#pragma once
#include <string>
#include <vector>

#include "bundle/bundle.h"
#include "importer/input_files.h"
#include "pipeline/recipe.h"

namespace crumple::pipeline {

// The files that the recipe's import would read (importer/input_files.h). Throws Error(usage) for names of visual
// meshes that are not unique.
[[nodiscard]] std::vector<importer::InputFile> input_files(const importer::Sources& sources, const Recipe& recipe);

// The name of each -> SHA-256 of its bytes. Throws Error(file) for a path that cannot be read, Error(bad_input) for one
// that another file names.
[[nodiscard]] std::vector<BundleProvenance::Entry> digest_inputs(const std::vector<importer::InputFile>& files);

[[nodiscard]] BundleProvenance::Entry digest_input(const std::string& name, const std::string& path);

}
