// SPDX-License-Identifier: GPL-3.0-or-later
// A described struct as JSON: keys in the order of describe(), numbers with the fewest digits that read back as the
// same number, not-a-number and infinities as null, an index that is none as null. Same struct, same bytes.
#pragma once
#include <string>

#include "report/described.h"
#include "report/json.h"

namespace crumple::report {

[[nodiscard]] Json build_json(Described value);
[[nodiscard]] std::string write_json(Described value, JsonStyle style = JsonStyle::indented);

}
