// SPDX-License-Identifier: GPL-3.0-or-later
// The tree behind write_json, for the sources of this module and of pipeline; never included by a public header.
#pragma once
#include "report/json_parse.h"
#include "report/json_writer.h"

namespace crumple::report {

[[nodiscard]] Json build_json(Described value);
[[nodiscard]] std::string dump_json(const Json& json, JsonStyle style);

}
