// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/console.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "pipeline/progress.h"
#include "report/json_writer.h"
#include "report/number_text.h"
#include "report/printable.h"
#include "report/text_view.h"

namespace crumple::cli {

namespace {

using pipeline::ProgressEvent;
using pipeline::ProgressLine;
using pipeline::Stage;
using pipeline::StageRun;
using pipeline::UsageMeter;

void put(std::FILE* stream, std::string_view text) {
    if (text.empty()) return;  // whose data may be null, which fwrite does not allow
    std::fwrite(text.data(), 1, text.size(), stream);
    std::fflush(stream);
}

void put_line(const ProgressLine& line) {
    put(stderr, report::write_json(report::Described::of(line), report::JsonStyle::compact) + "\n");
}

pipeline::Observer json_observer() {
    pipeline::Observer observer;
    observer.begin = [](const Stage& stage) {
        put_line({ProgressEvent::begin, std::string(stage.name), "", 0, {}, ""});
    };
    observer.progress = [](const Stage& stage, std::string_view step, double fraction, const UsageMeter& meter) {
        put_line({ProgressEvent::step, std::string(stage.name), std::string(step), fraction, meter.read(), ""});
    };
    observer.end = [](const Stage& stage, const StageRun& run, report::Described) {
        put_line({ProgressEvent::end, std::string(stage.name), "", 1, run.usage, ""});
    };
    return observer;
}

constexpr const char* erase_line = "\r\033[K";

pipeline::Observer terminal_observer() {
    pipeline::Observer observer;
    observer.begin = [](const Stage& stage) { put(stderr, erase_line + std::string(stage.name) + " ..."); };
    // Writing to a terminal costs more than many a step: only what changes the line is shown.
    const auto shown = std::make_shared<std::string>();
    observer.progress = [shown](const Stage& stage, std::string_view step, double fraction, const UsageMeter&) {
        const std::string line = std::string(stage.name) + " " + report::printable(step) + " " +
                                 std::to_string(std::lround(100 * fraction)) + " %";
        if (line == *shown) return;
        *shown = line;
        put(stderr, erase_line + line);
    };
    observer.end = [](const Stage&, const StageRun&, report::Described) { put(stderr, erase_line); };
    return observer;
}

bool is_terminal(int stream) { return isatty(stream) != 0; }

bool may_color(int stream) {
    const char* no_color = std::getenv("NO_COLOR");
    return is_terminal(stream) && !(no_color && *no_color);
}

}

Console::Console()
    : talks_to_terminal_(is_terminal(STDERR_FILENO)),
      colors_results_(may_color(STDOUT_FILENO)),
      colors_talk_(may_color(STDERR_FILENO)) {}

void Console::result(std::string_view text) const {
    // A result that did not arrive must not look like success to whoever reads only the exit code.
    const bool is_written = text.empty() || std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (std::fflush(stdout) != 0 || !is_written)
        throw Error(ErrorKind::file, "stdout: the result could not be written; is the disk full or the stream closed?");
}

void Console::talk(std::string_view text) const {
    if (!is_quiet && !is_for_programs()) put(stderr, text);
}

void Console::explain(std::string_view text) const {
    if (is_verbose && !is_for_programs()) put(stderr, text);
}

void Console::error(std::string_view message, std::string_view hint) const {
    const std::string line = report::shortened(message, report::longest_message);
    if (is_for_programs()) return put_line({ProgressEvent::error, "", "", 0, {}, line});
    if (shown_progress() == ProgressStyle::tty) put(stderr, erase_line);
    put(stderr, (colors_talk_ ? "\033[31merror:\033[0m " : "error: ") + report::printable(line) + "\n");
    put(stderr, hint);
}

ProgressStyle Console::shown_progress() const {
    if (progress != ProgressStyle::automatic) return progress;
    return talks_to_terminal_ && !is_quiet ? ProgressStyle::tty : ProgressStyle::none;
}

pipeline::Observer Console::observer() const {
    const ProgressStyle style = shown_progress();
    pipeline::Observer observer = style == ProgressStyle::json  ? json_observer()
                                  : style == ProgressStyle::tty ? terminal_observer()
                                                                : pipeline::Observer();
    if (!is_verbose || style == ProgressStyle::json) return observer;
    observer.log = [this](const Stage& stage, std::string_view message) {
        explain(std::string(stage.name) + ": " + report::printable(message) + "\n");
    };
    observer.end = [this, end = observer.end](const Stage& stage, const StageRun& run, report::Described stage_report) {
        if (end) end(stage, run, stage_report);
        explain(std::string(stage.name) + "\n" + report::report_text(stage_report, {.indent = 2}));
    };
    return observer;
}

}
