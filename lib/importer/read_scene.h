// SPDX-License-Identifier: GPL-3.0-or-later
// Reads one file: what runs in the child (read_scene), and how it is run (load_scene).
#pragma once
#include <string>

#include "formats/format.h"
#include "formats/prescan.h"
#include "importer/import.h"
#include "importer/scene.h"
#include "sandbox/sandbox.h"

namespace crumple::importer {

// Looks at the bytes, lets assimp read them, and copies what counts. May crash, hang or take all memory: assimp.
// Throws Error without the file's name.
[[nodiscard]] Scene read_scene(const std::string& path, const formats::Format& format, formats::Purpose purpose);

// Looks at the bytes only, those of other files that belong to it included. Throws as read_scene.
void look_at_bytes(const std::string& path, const formats::Format& format, formats::Purpose purpose);

// read_scene and look_at_bytes in a child process with the limits of params; whatever goes wrong there becomes an Error
// that begins with the path: file for a path that cannot be opened, budget where the system leaves too little memory
// (ulimit -v), bad_input for everything else.
[[nodiscard]] Scene load_scene(const std::string& path, formats::Purpose purpose, const Params& params);
void look_at_file(const std::string& path, formats::Purpose purpose, const Params& params);

[[nodiscard]] sandbox::Limits limits_of(const Params& params);

}
