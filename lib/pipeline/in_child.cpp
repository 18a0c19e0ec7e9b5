// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/in_child.h"

#include <span>

#include "sandbox/sandbox.h"

namespace crumple::pipeline {

namespace {

std::vector<std::byte> bytes_of(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

}

std::string run_text_in_child(const std::function<std::string()>& work, const std::string& name, double time_s) {
    using sandbox::Ending;
    const auto outcome = sandbox::run_in_child([&] { return bytes_of(work()); }, {.time_s = time_s});
    if (outcome.ending == Ending::ok)
        return {reinterpret_cast<const char*>(outcome.answer.data()), outcome.answer.size()};
    if (outcome.ending == Ending::out_of_time) {
        throw Error(ErrorKind::difference,
                    name + ": " + outcome.message + ": it is damaged, or the machine too slow or too busy for it");
    }
    if (outcome.ending == Ending::starved) throw Error(ErrorKind::budget, name + ": " + outcome.message);
    if (outcome.ending != Ending::refused) throw Error(ErrorKind::difference, name + ": damaged: " + outcome.message);
    if (outcome.kind == ErrorKind::usage) throw Error(ErrorKind::bad_input, name + ": " + outcome.message);
    throw Error(outcome.kind == ErrorKind::file ? ErrorKind::file : ErrorKind::difference, outcome.message);
}

}
