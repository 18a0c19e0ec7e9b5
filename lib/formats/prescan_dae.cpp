// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/dae_document.h"
#include "formats/dae_mesh.h"
#include "formats/dae_nodes.h"
#include "formats/prescan.h"

namespace crumple::formats {

Prescan prescan_dae(std::string_view text, Purpose purpose) {
    const dae::Document document = dae::parse(text);
    dae::check_unit(document);
    dae::check_meshes(document, purpose);
    dae::check_nodes(document);
    return prescan_numbers(text);
}

}
