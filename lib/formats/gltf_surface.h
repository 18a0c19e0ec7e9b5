// SPDX-License-Identifier: GPL-3.0-or-later
// What of a glTF file is a surface and its paint.
#pragma once
#include <string>
#include <vector>

#include "formats/gltf_document.h"
#include "formats/prescan.h"

namespace crumple::formats::gltf {

// The buffers in files of their own that used_buffers needs.
[[nodiscard]] std::vector<ExternalBuffer> external_buffers(const Json& json);

// The file without skins, animations, morphs, textures and whatever else assimp may crash on or get wrong: scenes,
// nodes, positions, colours where they are wanted, indices and names only. External buffers go by their
// ExternalBuffer::name there. REQUIRES: the document was found good (prescan_gltf).
[[nodiscard]] std::string surface_only(Document document, bool has_colors);

}
