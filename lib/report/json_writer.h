// SPDX-License-Identifier: GPL-3.0-or-later
// A described struct as JSON: keys in the order of describe(), numbers with the fewest digits that read back as the
// same number, not-a-number and infinities as null, an index that is none as null. Same struct, same bytes.
#pragma once
#include <string>

#include "report/described.h"

namespace crumple::report {

enum class JsonStyle {
    indented,  // for files and people, ends in a newline
    compact,   // one line without spaces: canonical text, lines of progress
};

[[nodiscard]] std::string write_json(Described value, JsonStyle style = JsonStyle::indented);

}
