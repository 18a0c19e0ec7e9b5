// SPDX-License-Identifier: GPL-3.0-or-later
// Reads files of unknown origin in a limited child process and brings the answer back as a described struct. Nearly all
// that goes wrong in there is damage to the file.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "report/described.h"
#include "report/json_reader.h"
#include "report/json_writer.h"

namespace crumple::pipeline {

// Throws Error(difference) "<name>: ..." when the work refuses the file, crashes or meets a limit. An Error of kind
// file stays one; that of kind usage, a whole file in which what is asked for is not there yet, becomes bad_input;
// where the system leaves too little memory (ulimit -v) it is one of kind budget. `time_s` by the wall.
[[nodiscard]] std::string run_text_in_child(const std::function<std::string()>& work, const std::string& name,
                                            double time_s = 120);

template <class Answer>
[[nodiscard]] Answer run_described_in_child(const std::function<Answer()>& work, const std::string& name,
                                            double time_s = 120) {
    const std::string json = run_text_in_child(
        [&] {
            const Answer answer = work();
            return report::write_json(report::Described::of(answer), report::JsonStyle::compact);
        },
        name, time_s);
    Answer answer;
    report::read_json(json, name, report::Described::of(answer), {.kind = ErrorKind::difference, .allows_null = true});
    return answer;
}

}
