// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace crumple::importer {

// The whole of a plain file; a pipe or device is refused rather than waited for. Throws Error(file) without the file's
// name.
[[nodiscard]] std::string read_file(const std::string& path);

// Throws as read_file, before anything is read.
void check_can_open(const std::string& path);

}
