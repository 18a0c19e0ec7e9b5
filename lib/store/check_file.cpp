// SPDX-License-Identifier: MIT
#include "store/check_file.h"

#include <algorithm>
#include <map>

#include "bundle/validate.h"
#include "core/error.h"
#include "store/bundle_file.h"
#include "store/check_view.h"

namespace crumple::store {
namespace {

const std::string digest_prefix = "/digest/";

void complain(std::vector<Finding>& findings, const char* code, const char* message, const std::string& path) {
    auto finding = std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.code == code; });
    if (finding == findings.end()) finding = findings.insert(findings.end(), {code, Severity::error, message, 0, {}});
    count_one(*finding, {nowhere, none, path});
}

// The list in /digest; empty with a complaint when it does not agree with itself.
std::map<std::string, Digest> read_digests(const FileReader& file, std::vector<Finding>& findings) {
    const std::vector<std::string> paths = file.read_texts(digest_prefix + "path");
    const std::vector<Digest> digests = file.read<Digest>(digest_prefix + "sha256");
    std::map<std::string, Digest> list;
    for (std::size_t i = 0; i < std::min(paths.size(), digests.size()); ++i) list[paths[i]] = digests[i];
    Sha256 all;
    for (const auto& [path, digest] : list) all.update(path + "\t" + to_hex(digest) + "\n");
    const bool agrees = paths.size() == digests.size() && list.size() == paths.size() &&
                        file.read_value<Digest>(digest_prefix + "all") == all.finish();
    if (!agrees) {
        complain(findings, "FILE_DIGESTS", "the list of digests does not agree with its own digest",
                 digest_prefix + "all");
    }
    return list;
}

void compare_digest(std::map<std::string, Digest>& list, const std::string& path, const Dataset& dataset,
                    std::vector<Finding>& findings) {
    const auto entry = list.find(path);
    if (entry == list.end()) {
        complain(findings, "FILE_UNLISTED", "a dataset or attribute has no digest", path);
        return;
    }
    if (digest_of(dataset.info, dataset.bytes) != entry->second) {
        complain(findings, "FILE_DAMAGED", "the content of a dataset or attribute is not what was written", path);
    }
    list.erase(entry);
}

Dataset read_attribute_at(const FileReader& file, const std::string& path) {
    const std::size_t at = path.rfind('@');
    return file.read_attribute(path.substr(0, at), path.substr(at + 1));
}

}

std::vector<Finding> verify_digests(const FileReader& file) {
    std::vector<Finding> findings;
    std::map<std::string, Digest> list = read_digests(file, findings);
    for (const std::string& path : file.all_datasets()) {
        if (!path.starts_with(digest_prefix)) compare_digest(list, path, file.read_bytes(path), findings);
    }
    for (const std::string& path : file.all_attributes())
        compare_digest(list, path, read_attribute_at(file, path), findings);
    for (const auto& [path, digest] : list) complain(findings, "FILE_MISSING", "a dataset or attribute is gone", path);
    return findings;
}

std::string content_digest(const FileReader& file) { return to_hex(file.read_value<Digest>(digest_prefix + "all")); }

namespace {

void check_bundle(const FileReader& file, CheckedFile& checked) {
    checked.bundle = read_bundle(file);
    for (const std::string& path : find_view_differences(file, *checked.bundle)) {
        complain(checked.findings, "FILE_VIEW", "the view for ParaView shows something else than the bundle says",
                 path);
    }
    const std::vector<Finding> wrong = validate(*checked.bundle);
    checked.findings.insert(checked.findings.end(), wrong.begin(), wrong.end());
}

// A finding is about the file: it need not say which.
std::string without_name(const std::string& message, const std::string& name) {
    return message.starts_with(name + ": ") ? message.substr(name.size() + 2) : message;
}

}

CheckedFile check_file(std::vector<std::byte> image, const std::string& name) {
    CheckedFile checked;
    try {
        const FileReader file(std::move(image), name);
        checked.findings = verify_digests(file);
        checked.digest = content_digest(file);
        if (has_bundle(file)) check_bundle(file, checked);
    } catch (const Error& error) {
        checked.findings.push_back({"FILE_UNREADABLE", Severity::error, without_name(error.what(), name), 1, {}});
    }
    return checked;
}

}
