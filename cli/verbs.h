// SPDX-License-Identifier: GPL-3.0-or-later
// One function a family of verbs: it declares the options and leaves in the session what to run once all are read.
#pragma once
#include <functional>

#include "cli/console.h"

namespace CLI {
class App;
}

namespace crumple::cli {

struct Session {
    Console console;
    std::function<int()> run;  // returns the exit code
};

void add_cook(CLI::App& app, Session& session);
void add_stages(CLI::App& app, Session& session);
void add_check(CLI::App& app, Session& session);
void add_inspect(CLI::App& app, Session& session);
void add_compare(CLI::App& app, Session& session);
void add_export(CLI::App& app, Session& session);
void add_simulate(CLI::App& app, Session& session);
void add_dev(CLI::App& app, Session& session);

}
