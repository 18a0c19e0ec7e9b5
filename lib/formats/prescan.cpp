// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/prescan.h"

namespace crumple::formats {

Prescan prescan(std::string_view bytes, FormatId format, Purpose purpose) {
    switch (format) {
        case FormatId::obj:
            return prescan_obj(bytes, purpose);
        case FormatId::ply:
            return prescan_ply(bytes, purpose);
        case FormatId::off:
            return prescan_off(bytes, purpose);
        case FormatId::gltf:
            return prescan_gltf(bytes, purpose);
        case FormatId::dae:
            return prescan_dae(bytes, purpose);
        case FormatId::fbx:
            return prescan_fbx(bytes, purpose);
        case FormatId::x:
            return prescan_x(bytes, purpose);
        case FormatId::stl:
            return prescan_numbers(bytes);
    }
    return {};
}

}
