// SPDX-License-Identifier: GPL-3.0-or-later
// The options that say what to read: those of `cook` and of `import`.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "importer/import.h"
#include "pipeline/recipe.h"

namespace CLI {
class App;
}

namespace crumple::cli {

struct Setting {
    std::string option;  // "--unit 0.01": what the user wrote
    std::string text;    // "import.unit=0.01"
};

struct ImportFlags {
    std::string shell;
    std::vector<std::string> visuals;  // "[NAME=]FILE"
    std::vector<Setting> settings;     // in the order of the flags
};

// The flags live as long as the verb's command.
[[nodiscard]] std::shared_ptr<ImportFlags> add_import_flags(CLI::App& verb);

void apply_settings(pipeline::Recipe& recipe, const std::vector<Setting>& settings);

[[nodiscard]] importer::Sources sources_of(const ImportFlags& flags);

// Every file that import would read for the recipe, those that the artist's files need included, each once.
[[nodiscard]] std::vector<std::string> input_paths(const importer::Sources& sources, const pipeline::Recipe& recipe);

}
