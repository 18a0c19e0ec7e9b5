// SPDX-License-Identifier: GPL-3.0-or-later
// One option for every single-valued parameter of a stage, out of its describe(): --sweeps is the recipe's
// relax.sweeps.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "cli/import_flags.h"

namespace CLI {
class App;
}

namespace crumple::pipeline {
struct Stage;
}

namespace crumple::cli {

// Settings are appended as the flags are read.
void add_stage_flags(CLI::App& verb, const pipeline::Stage& stage, std::vector<Setting>& settings);

// "sweeps=5" means "relax.sweeps=5" when the stage is relax.
[[nodiscard]] std::string with_stage(std::string_view stage, const std::string& setting);

}
