// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/dae_document.h"
#include "importer/dae_mesh.h"
#include "importer/dae_nodes.h"
#include "importer/prescan.h"

namespace crumple::importer {

Prescan prescan_dae(std::string_view text, Purpose purpose) {
    const dae::Document document = dae::parse(text);
    dae::check_unit(document);
    dae::check_meshes(document, purpose);
    dae::check_nodes(document);
    return prescan_numbers(text);
}

}
