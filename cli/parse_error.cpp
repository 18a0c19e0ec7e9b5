// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/parse_error.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <utility>

#include "core/names.h"
#include "report/printable.h"

namespace crumple::cli {

namespace {

// The root, its verb, the verb's verb: as far as they were found.
std::vector<const CLI::App*> chosen_apps(const CLI::App& app) {
    std::vector<const CLI::App*> chosen{&app};
    for (auto next = app.get_subcommands(); !next.empty(); next = chosen.back()->get_subcommands())
        chosen.push_back(next.front());
    return chosen;
}

std::vector<std::string> option_names(const std::vector<const CLI::App*>& apps) {
    std::vector<std::string> names;
    for (auto app = apps.rbegin(); app != apps.rend(); ++app) {
        for (const CLI::Option* option : (*app)->get_options()) {
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        }
    }
    return names;
}

std::vector<std::string> verb_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(verb->get_name());
    return names;
}

std::string first_unplaced(const CLI::App& app, const std::vector<std::string>& words) {
    const std::vector<std::string> unplaced = app.remaining(true);
    const auto is_unplaced = [&](const std::string& word) {
        return std::find(unplaced.begin(), unplaced.end(), word) != unplaced.end();
    };
    const auto first = std::find_if(words.begin(), words.end(), is_unplaced);
    return first == words.end() ? std::string() : *first;
}

std::string explain_word(const CLI::App& app, const std::string& word) {
    const std::vector<const CLI::App*> chosen = chosen_apps(app);
    const std::string shown = "'" + report::shortened(word, report::longest_name) + "'";
    // A single letter is like nothing.
    if (word.starts_with("-") && word.size() == 2) return understood_call(app) + " has no option " + shown;
    if (word.starts_with("-")) {
        const std::string name = word.substr(0, word.find('='));
        return understood_call(app) + " has no option " + shown + "; nearest: '" +
               nearest_name(name, option_names(chosen)) + "'";
    }
    const std::vector<std::string> verbs = verb_names(*chosen.back());
    if (verbs.empty()) return understood_call(app) + " has no use for the word " + shown;
    return understood_call(app) + " has no verb " + shown + "; nearest: '" + nearest_name(word, verbs) + "'";
}

// "--shell: At Most 1 required but received 2", in our words.
std::string explain_count(std::string text) {
    const std::size_t colon = text.find(": 1 required ");
    if (colon != std::string::npos && text.ends_with(" missing"))
        return text.substr(0, colon) + ": its value is missing";
    static constexpr std::pair<std::string_view, std::string_view> words[] = {
        {"At Most ", "takes no more than "}, {"At least ", "wants at least "}, {" required but received ", ", found "}};
    for (const auto& [theirs, ours] : words) {
        if (const std::size_t at = text.find(theirs); at != std::string::npos) text.replace(at, theirs.size(), ours);
    }
    return text;
}

}

std::string understood_call(const CLI::App& app) {
    std::string call;
    for (const CLI::App* part : chosen_apps(app)) call += (call.empty() ? "" : " ") + part->get_name();
    return call;
}

std::string explain_parse_error(const CLI::App& app, const CLI::ParseError& error,
                                const std::vector<std::string>& words) {
    const bool may_be_a_slip =
        dynamic_cast<const CLI::ExtrasError*>(&error) || dynamic_cast<const CLI::RequiredError*>(&error);
    const std::string word = may_be_a_slip ? first_unplaced(app, words) : std::string();
    if (!word.empty()) return explain_word(app, word);
    return dynamic_cast<const CLI::ArgumentMismatch*>(&error) ? explain_count(error.what()) : error.what();
}

}
