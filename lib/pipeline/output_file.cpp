// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/output_file.h"

#include <algorithm>
#include <filesystem>

#include "core/counted.h"
#include "core/error.h"
#include "pipeline/bundle_gates.h"
#include "pipeline/work_file.h"
#include "store/read_file.h"
#include "store/write_file.h"

namespace crumple::pipeline {

namespace {

// Nobody made a link of it, or protected it.
bool is_as_we_left_it(const std::string& path) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::symlink_status(path, ignored);
    return std::filesystem::is_regular_file(status) &&
           (status.permissions() & std::filesystem::perms::owner_write) != std::filesystem::perms::none;
}

// Best effort: the cook went well whatever becomes of it.
void forget_rejected(const std::string& path) {
    if (!is_as_we_left_it(path)) return;
    try {
        std::error_code ignored;
        const Workspace work = read_work_file(path);
        if (work.bundle && !refused_by(work).empty()) std::filesystem::remove(path, ignored);
    } catch (const Error&) {
        return;  // no file of ours
    }
}

}

void check_output_path(const std::string& path, const std::vector<std::string>& inputs) {
    if (path.empty()) throw Error(ErrorKind::usage, "-o: it names no file");
    if (std::filesystem::path(path).extension() != ".hdf") {
        throw Error(ErrorKind::usage, path + ": the output's name must end in .hdf (ParaView opens no other)");
    }
    store::check_can_write(path);
    for (const std::string& input : inputs) {
        std::error_code ignored;
        if (std::filesystem::equivalent(path, input, ignored)) {
            throw Error(ErrorKind::usage, path + ": the output would replace an input");
        }
    }
}

std::string rejected_path(const std::string& output) {
    std::filesystem::path path(output);
    return path.replace_extension(".rejected.hdf").string();
}

void reject(const std::vector<Finding>& findings, const std::string& output, const std::vector<std::byte>& image) {
    const auto count = std::count_if(findings.begin(), findings.end(),
                                     [](const Finding& finding) { return finding.severity == Severity::error; });
    std::string message = output + ": " +
                          counted(static_cast<std::uint64_t>(count), "quality gate is", "quality gates are") +
                          " not met (" + error_codes(findings) + "); the file stays as it was, ";
    try {
        (void)write_if_changed(rejected_path(output), image);
        message += "look at the result in " + rejected_path(output);
    } catch (const Error& error) {
        message += std::string("and the result could not be kept: ") + error.what();
    }
    throw Error(ErrorKind::quality, message);
}

bool accept(const std::string& output, const std::vector<std::byte>& image) {
    const bool is_changed = write_if_changed(output, image);
    forget_rejected(rejected_path(output));
    return is_changed;
}

bool holds(const std::string& path, const std::vector<std::byte>& image) {
    std::error_code ignored;
    if (std::filesystem::file_size(path, ignored) != image.size() || ignored) return false;
    const std::vector<std::byte> old = store::read_file(path);
    return std::equal(old.begin(), old.end(), image.begin(), image.end());
}

bool write_if_changed(const std::string& path, const std::vector<std::byte>& image) {
    if (holds(path, image)) return false;
    store::write_file(path, image);
    return true;
}

}
