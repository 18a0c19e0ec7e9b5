// SPDX-License-Identifier: GPL-3.0-or-later
// Text to a JSON tree with limits, for the sources of this module and of pipeline; never included by a public header.
#pragma once
#include <nlohmann/json.hpp>
#include <string_view>

#include "report/json_reader.h"

namespace crumple::report {

using Json = nlohmann::ordered_json;

// Throws Error(rules.kind) for broken text (with line and column), a repeated key (with its path), too much or too
// deep.
[[nodiscard]] Json parse_json(std::string_view text, std::string_view source, const ReadRules& rules);

}
