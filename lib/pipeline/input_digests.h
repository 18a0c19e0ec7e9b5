// SPDX-License-Identifier: GPL-3.0-or-later
// What a bundle remembers of its inputs: their content, never where they lay.
#pragma once
#include <string>
#include <vector>

#include "bundle/bundle.h"
#include "importer/import.h"

namespace crumple::pipeline {

// "shell" and "visual/<name>" -> SHA-256 of the file's bytes. Throws Error(file) for a path that cannot be read,
// Error(usage) for names that are not unique.
[[nodiscard]] std::vector<BundleProvenance::Entry> digest_inputs(const importer::Sources& sources);

[[nodiscard]] BundleProvenance::Entry digest_input(const std::string& name, const std::string& path);

}
