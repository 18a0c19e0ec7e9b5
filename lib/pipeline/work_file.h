// SPDX-License-Identifier: GPL-3.0-or-later
// A workspace in an HDF5 file, extension .hdf: one group per part (/asset /points /tets /bindings and the bundle's
// own), and /cook with what is known about how they came to be. A bundle is a work file whose other groups were left
// out.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/workspace.h"
#include "store/hdf5_file.h"

namespace crumple::pipeline {

struct FileContents {
    bool has_work = true;  // asset, points, tets and bindings; false leaves only the bundle and /cook
    store::Layout layout = store::Layout::compressed;
};

// The bytes of the file; equal for equal workspaces. Sources are not part of it.
[[nodiscard]] std::vector<std::byte> work_image(const Workspace& workspace, const FileContents& contents);

// Every part the file has, or the bundle of a blob (bundle/blob.h), every index and size checked. Throws Error(file)
// when it cannot be read, Error(bad_input) when it is no file of ours, is damaged or holds what no stage would have
// written. REQUIRES: no other thread of this process is running: the file is tried in a limited child process first.
[[nodiscard]] Workspace read_work_file(const std::string& path);

// The same without a child process, for those who are in one.
[[nodiscard]] Workspace read_work_image(std::vector<std::byte> image, const std::string& name);

}
