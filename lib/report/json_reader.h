// SPDX-License-Identifier: GPL-3.0-or-later
// Strict JSON into a described struct. An unknown or repeated key, a wrong type, a number out of range or a name that
// is none of the choices stops with the path of the key and the nearest valid name. Keys that are absent keep what the
// struct holds.
#pragma once
#include <string>
#include <string_view>

#include "report/described.h"
#include "report/json.h"

namespace crumple::report {

// `source` names the text in messages. The text may come from anywhere: size and nesting are limited before anything
// is built. A string "$schema" at the top is allowed and ignored.
void read_json(std::string_view text, std::string_view source, Described value, const ReadRules& rules = {});

// One assignment "relax.sweeps=5", as given to --set: the path of a field, then its value: text and choices as they
// are (or in JSON's quotes), everything else as JSON. In a map of single values the rest of the path is the key, dots
// and all. `option` names the flag in messages where it was not --set.
void apply_setting(std::string_view setting, Described root, std::string_view option = {});

}
