// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "formats/fbx_document.h"
#include "formats/fbx_mesh.h"
#include "formats/prescan.h"

namespace crumple::formats {

namespace {

// Properties70 { P: name, type, type, flags, value }.
constexpr std::size_t value_of_property = 4;

void check_unit(const fbx::Document& document) {
    const Index settings = fbx::find_child(document, 0, "GlobalSettings");
    const Index properties = settings == none ? none : fbx::find_child(document, settings, "Properties70");
    if (properties == none) return;
    fbx::for_each_child(document, properties, "P", [&](Index property) {
        const fbx::Node& node = document.nodes[property];
        if (fbx::text_of(document, node, 0) != "UnitScaleFactor") return;
        const auto factor = fbx::number_of(document, node, value_of_property);
        if (!factor || !(*factor > 0) || !std::isfinite(*factor))
            fbx::refuse(document, node,
                        "UnitScaleFactor is " + (factor ? std::to_string(*factor) : "no number") +
                            ", which is no length in centimetres");
    });
}

}

Prescan prescan_fbx(std::string_view bytes, Purpose purpose) {
    const fbx::Document document = fbx::parse(bytes);
    check_unit(document);
    Prescan result = prescan_numbers(bytes);
    fbx::check_meshes(document, purpose, result.unread);
    return result;
}

}
