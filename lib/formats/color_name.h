// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string_view>

namespace crumple::formats {

// "Red", "diffuse_red", "vertex-colors", "rgb": what someone would take for a colour. Not "color_index".
[[nodiscard]] bool looks_like_color(std::string_view name);

}
