// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace crumple::importer {

// The whole file. Throws Error(file) without the file's name.
[[nodiscard]] std::string read_file(const std::string& path);

}
