// SPDX-License-Identifier: MIT
// A whole file as bytes.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace crumple::store {

// Throws Error(file) that says why: missing, a folder, no permission.
[[nodiscard]] std::vector<std::byte> read_file(const std::string& path);

}
