// SPDX-License-Identifier: GPL-3.0-or-later
// An option that takes one of a few words.
#pragma once
#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "core/fields.h"
#include "core/names.h"
#include "report/printable.h"

namespace crumple::cli {

// A word that is none of the choices ends the parse with all of them and the nearest.
template <class E, std::size_t count>
void add_choice_flag(CLI::App& verb, const std::string& option, E& target, const EnumName<E> (&choices)[count],
                     const std::string& help) {
    std::vector<std::string> names;
    for (const EnumName<E>& choice : choices) names.emplace_back(choice.name);
    std::string type;
    for (const std::string& name : names) type += (type.empty() ? "" : "|") + name;
    const auto choose = [&target, &choices, names, option](const std::string& word) {
        for (const EnumName<E>& choice : choices) {
            if (choice.name != word) continue;
            target = choice.value;
            return;
        }
        throw CLI::ValidationError(option, "'" + report::shortened(word, report::longest_name) + "' is not one of " +
                                               list_names(names) + "; nearest: '" + nearest_name(word, names) + "'");
    };
    verb.add_option_function<std::string>(option, choose, help)->type_name(type);
}

}
