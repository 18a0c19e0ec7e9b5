// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a finished work file or bundle: put at the output's place when it is accepted, beside it when a gate
// refuses it.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/finding.h"

namespace crumple::pipeline {

// A path that ends in .hdf and can be written, and is none of the inputs. Throws Error(usage) or Error(file).
void check_output_path(const std::string& path, const std::vector<std::string>& inputs);

// "car.hdf" -> "car.rejected.hdf": where a result goes that fails a gate.
[[nodiscard]] std::string rejected_path(const std::string& output);

// Puts the image there, the output stays as it was. Throws Error(quality) that names the gates and both files.
[[noreturn]] void reject(const std::vector<Finding>& findings, const std::string& output,
                         const std::vector<std::byte>& image);

// Puts the image at the output, and takes away a result that was refused there before, if its record says that a
// gate refused it: what nobody asks about any more would be taken for news. A link or a read-only file stays. Returns
// false when the output held these bytes already.
bool accept(const std::string& output, const std::vector<std::byte>& image);

// The file is there with these bytes.
[[nodiscard]] bool holds(const std::string& path, const std::vector<std::byte>& image);

// Returns false, and touches nothing, when the file holds these bytes already.
bool write_if_changed(const std::string& path, const std::vector<std::byte>& image);

}
