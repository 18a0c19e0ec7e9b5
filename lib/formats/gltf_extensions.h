// SPDX-License-Identifier: GPL-3.0-or-later
// Which extensions of glTF change what a surface is or how it is painted, and which are about something else.
#pragma once
#include <string>
#include <vector>

#include "formats/gltf_document.h"

namespace crumple::formats::gltf {

// The extensions that a file requires and that its surface does not need. Throws Error(bad_input) for one that changes
// the surface or that nobody here knows: glTF 2.0, section 3.12, forbids loading such a file.
[[nodiscard]] std::vector<std::string> check_extensions(const Json& document);

}
