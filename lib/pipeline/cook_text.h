// SPDX-License-Identifier: GPL-3.0-or-later
// What a cook and a dry run tell a person.
#pragma once
#include <string>

#include "pipeline/cook.h"

namespace crumple::pipeline {

// A row a stage, all findings, and what became of the output.
[[nodiscard]] std::string cook_text(const CookReport& report, const std::string& output, bool has_color);

[[nodiscard]] std::string dry_run_text(const DryRunReport& report, const std::string& output);

}
