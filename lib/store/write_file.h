// SPDX-License-Identifier: MIT
// Puts a whole file in place or leaves the old one alone: writes beside the target, flushes to the disk, renames.
#pragma once
#include <cstddef>
#include <span>
#include <string>

namespace crumple::store {

// A killed process leaves the old file or the new one. The new one is nameless until it is complete, then for the
// moment before the rename a hidden ".crumple-<process>-<number>.tmp" beside the target, which a kill just then leaves
// there; on file systems without nameless files it is that from the start. A link is followed: the file it points to is
// replaced. Other threads and signal handlers are not disturbed when a size limit (SIGXFSZ) is hit. Throws Error(file)
// that says why: missing folder, read-only folder, the target is a folder or a file that is read-only, the disk is
// full.
void write_file(const std::string& path, std::span<const std::byte> bytes);

// Throws as write_file would for what can be known beforehand; for use before hours of work. Writes nothing.
void check_can_write(const std::string& path);

}
