// SPDX-License-Identifier: MIT
// Everything `check` can say about a file without its inputs: is every byte as written, is every invariant true.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "bundle/bundle.h"
#include "core/finding.h"
#include "store/hdf5_file.h"

namespace crumple::store {

// Every dataset and attribute against its digest: FILE_DAMAGED (bytes differ), FILE_UNLISTED (no digest), FILE_MISSING
// (digest without data), FILE_DIGESTS (the list itself is wrong). Empty when all is as written.
[[nodiscard]] std::vector<Finding> verify_digests(const FileReader& file);

// The digest over all datasets and attributes, as hexadecimal: equal for equal content whatever the layout, the zlib or
// the order of writing.
[[nodiscard]] std::string content_digest(const FileReader& file);

struct CheckedFile {
    std::optional<Bundle> bundle;   // when the file has one (a work file may not) and it could be read
    std::string digest;             // content_digest, empty when the file could not be opened
    std::vector<Finding> findings;  // severity error: damage or a broken invariant
};

// Never throws for what is in the bytes; the findings do not repeat the name. HDF5 itself has been seen to crash on
// hostile files with a forged seal: run it in a sandbox. The name is for messages.
[[nodiscard]] CheckedFile check_file(std::vector<std::byte> image, const std::string& name);

}
