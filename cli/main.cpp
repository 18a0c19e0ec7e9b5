// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/arguments.h"
#include "cli/guarded.h"
#include "cli/parse_error.h"
#include "cli/verbs.h"
#include "pipeline/exit_codes.h"
#include "pipeline/version.h"
#include "report/json_writer.h"

namespace {

using crumple::cli::Session;

void declare(CLI::App& app, Session& session) {
    app.fallthrough();
    app.require_subcommand(0, 1);
    app.get_formatter()->column_width(34);
    app.set_help_flag("-h,--help", "print this and exit");
    app.add_flag("-q,--quiet", session.console.is_quiet, "say nothing but errors");
    app.add_flag("-v,--verbose", session.console.is_verbose, "say more");
    app.footer(
        "Exit codes: 0 ok, 1 usage, 2 file, 3 input refused, 4 quality, 5 bug, 6 budget, 7 difference.\n"
        "Example: crumple cook car_body --shell car.glb --visual car_detail.glb -o car.hdf");
    crumple::cli::add_cook(app, session);
    crumple::cli::add_check(app, session);
    crumple::cli::add_inspect(app, session);
    crumple::cli::add_compare(app, session);
    crumple::cli::add_export(app, session);
    crumple::cli::add_stages(app, session);
    crumple::cli::add_simulate(app, session);
    crumple::cli::add_dev(app, session);
}

int print_version(const Session& session, bool as_json) {
    const auto info = crumple::pipeline::version_info();
    session.console.result(as_json ? crumple::report::write_json(crumple::report::Described::of(info))
                                   : "crumple " + info.version + "\n");
    return crumple::pipeline::exit_ok;
}

// CLI11 has exit codes of its own; ours are 0 for help and 1 for everything it refuses.
int parse(CLI::App& app, const std::vector<std::string>& arguments, Session& session) {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    try {
        app.parse(reversed);
        return crumple::pipeline::exit_ok;
    } catch (const CLI::Success& request) {
        app.exit(request);
        return -1;
    } catch (const CLI::ParseError& error) {
        if (crumple::cli::asks_for_json_lines(arguments)) session.console.progress = crumple::cli::ProgressStyle::json;
        session.console.error(crumple::cli::explain_parse_error(app, error, arguments),
                              "see " + crumple::cli::understood_call(app) + " --help\n");
        return crumple::pipeline::exit_usage;
    }
}

int run(int count, const char* const* words, Session& session) {
    CLI::App app(
        "Cooks deformable game assets: a painted control shell and its detailed mesh in, a checked bundle out.",
        "crumple");
    bool wants_version = false;
    bool as_json = false;
    declare(app, session);
    app.add_flag("--version", wants_version, "print the version and exit; with --json also the stages'");
    app.add_flag("--json", as_json)->group("");
    const int parsed = parse(app, crumple::cli::expand_arguments(count, words), session);
    if (parsed != crumple::pipeline::exit_ok) return std::max(parsed, 0);
    if (wants_version) return print_version(session, as_json);
    if (session.run) return session.run();
    session.console.error("no verb", app.help());
    return crumple::pipeline::exit_usage;
}

}

int main(int count, char** words) {
    Session session;
    return crumple::cli::run_guarded(session.console, [&] { return run(count, words, session); });
}
