// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "core/error.h"
#include "importer/read_scene.h"
#include "importer/source_file.h"

namespace crumple::importer {

namespace {

void check_given(const std::string& path) {
    if (path.empty()) throw Error(ErrorKind::file, "the path of an input is empty; say which file");
    try {
        check_can_open(path);
    } catch (const Error& error) {
        throw Error(error.kind(), path + ": " + error.what());
    }
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw Error(ErrorKind::bad_input, path + ": " + why);
}

[[noreturn]] void report(const std::string& path, const sandbox::Outcome& outcome) {
    using sandbox::Ending;
    switch (outcome.ending) {
        case Ending::out_of_time:
            refuse(path, outcome.message + "; the file may be damaged or too large (import.time_s raises the limit)");
        case Ending::out_of_memory:
            refuse(path,
                   outcome.message + "; the file may be damaged or too large (import.memory_mb raises the limit)");
        case Ending::starved:
            throw Error(ErrorKind::budget, path + ": " + outcome.message);
        case Ending::crashed:
            refuse(path, "the reader crashed on it (" + outcome.message +
                             "): the file is damaged or uses what the reader "
                             "cannot read; export it again, or in another format");
        case Ending::ok:
        case Ending::refused:
            break;
    }
    const bool is_ours = outcome.kind == ErrorKind::internal || outcome.kind == ErrorKind::file;
    throw Error(is_ours ? outcome.kind : ErrorKind::bad_input, path + ": " + outcome.message);
}

// What the work answers in a child process.
std::vector<std::byte> answer_of(const std::string& path, const Params& params,
                                 const std::function<std::vector<std::byte>()>& work) {
    auto outcome = sandbox::run_in_child(work, limits_of(params));
    if (outcome.ending != sandbox::Ending::ok) report(path, outcome);
    return std::move(outcome.answer);
}

}

sandbox::Limits limits_of(const Params& params) {
    sandbox::Limits limits;
    limits.memory_bytes = std::size_t{params.memory_mb} << 20;
    limits.answer_bytes = limits.memory_bytes;
    limits.time_s = params.time_s;
    return limits;
}

Scene load_scene(const std::string& path, formats::Purpose purpose, const Params& params) {
    check_given(path);
    const formats::Format& format = formats::format_of(path);
    const auto answer = answer_of(path, params, [&] { return encode(read_scene(path, format, purpose)); });
    try {
        return decode(answer);
    } catch (const Error& error) {
        throw Error(error.kind(), path + ": " + error.what());
    }
}

void look_at_file(const std::string& path, formats::Purpose purpose, const Params& params) {
    check_given(path);
    const formats::Format& format = formats::format_of(path);
    (void)answer_of(path, params, [&] {
        look_at_bytes(path, format, purpose);
        return std::vector<std::byte>();
    });
}

}
