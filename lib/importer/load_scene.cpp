// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/error.h"
#include "importer/read_scene.h"
#include "sandbox/sandbox.h"

namespace crumple::importer {

namespace {

void check_can_open(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
        const char* what = S_ISDIR(status.st_mode) ? "a folder" : "a device or pipe";
        throw Error(ErrorKind::file, path + ": is " + what + "; a file was expected");
    }
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (!file) throw Error(ErrorKind::file, path + ": cannot be opened: " + std::strerror(errno));
    std::fclose(file);
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
        case Ending::crashed:
            refuse(path, "the reader crashed on it (" + outcome.message +
                             "): the file is damaged or uses what the reader "
                             "cannot read; export it again, or in another format");
        case Ending::ok:
        case Ending::refused:
            break;
    }
    const auto kind = static_cast<ErrorKind>(outcome.error_kind);
    const bool is_ours = kind == ErrorKind::internal || kind == ErrorKind::file;
    throw Error(is_ours ? kind : ErrorKind::bad_input, path + ": " + outcome.message);
}

}

Scene load_scene(const std::string& path, Purpose purpose, const Params& params) {
    check_can_open(path);
    const Format& format = format_of(path);
    sandbox::Limits limits;
    limits.memory_bytes = std::size_t{params.memory_mb} << 20;
    limits.answer_bytes = limits.memory_bytes;
    limits.time_s = params.time_s;
    const auto outcome = sandbox::run_in_child([&] { return encode(read_scene(path, format, purpose)); }, limits);
    if (outcome.ending != sandbox::Ending::ok) report(path, outcome);
    try {
        return decode(outcome.answer);
    } catch (const Error& error) {
        throw Error(error.kind(), path + ": " + error.what());
    }
}

}
