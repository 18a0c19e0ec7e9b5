// SPDX-License-Identifier: GPL-3.0-or-later
// The gates asked of what a workspace holds: by the stage `gates` when it is cooked, and again by `check`.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gates/gates.h"
#include "pipeline/workspace.h"

namespace crumple::pipeline {

// REQUIRES: the workspace has asset and bundle.
[[nodiscard]] gates::Report judge_cooked(const Workspace& workspace, const gates::Params& params,
                                         const Context& context);

// Where the figures that need the shell come from.
enum class ShellFigures { none, stored, measured };
inline constexpr EnumName<ShellFigures> shell_figures_names[] = {
    {ShellFigures::none, "none"}, {ShellFigures::stored, "stored"}, {ShellFigures::measured, "measured"}};
constexpr std::span<const EnumName<ShellFigures>> enum_names(ShellFigures) { return shell_figures_names; }

struct GateCheck {
    ShellFigures shell = ShellFigures::none;
    bool was_asked = false;  // the file has been through the gates; else none of them fails it
    gates::Params params;    // as the file was cooked
    gates::Report report;
};

// REQUIRES: the workspace has a bundle, and it is valid.
[[nodiscard]] GateCheck check_gates(const Workspace& workspace);

// The codes of findings that are errors, joined by ", ".
[[nodiscard]] std::string error_codes(std::span<const Finding> findings);

// The codes of the gates that refused it when it was cooked, joined by ", "; empty when none did, or none was asked.
[[nodiscard]] std::string refused_by(const Workspace& workspace);

// What the stage told when the file was cooked; null when it did not run, or in another version.
struct ToldGates {
    gates::Params params;
    gates::Report report;
};
[[nodiscard]] std::optional<ToldGates> told_gates(const std::vector<StageRecord>& records);

}
